#pragma once

#include "solver/foundation/types.h"

#include <concepts>
#include <type_traits>

namespace plumbline {

template <class T> T zero() {
    if constexpr (std::is_arithmetic_v<T>)
        return T{0};
    else
        return T::Zero();
}

/// Σⱼ term(j) over `js`, in the order given.
/// `term` must return exactly T: an Eigen expression would outlive its operands.
template <class T, class Range, class Term>
requires std::same_as<std::invoke_result_t<Term, Index>, T> T sum(const Range& js, Term term) {
    T total = zero<T>();
    for (const Index j : js) total += term(j);
    return total;
}

}  // namespace plumbline
