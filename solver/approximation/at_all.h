#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/types.h"

#include <type_traits>
#include <vector>

namespace plumbline {

/// {op(0), …, op(n − 1)} on all threads: `at_all(n, [&](Index i) { return density(w, x, m, s.at(i)); })`.
/// `op` must return a value, not an Eigen expression, which would outlive its operands.
template <class Op> auto at_all(std::size_t n, Op op) {
    using Result = std::invoke_result_t<Op, Index>;
    static_assert(!std::is_same_v<Result, bool>, "threads cannot share the bits of vector<bool>");
    std::vector<Result> results(n);
    parallel_for(n, [&](std::size_t i) { results[i] = op(static_cast<Index>(i)); });
    return results;
}

}  // namespace plumbline
