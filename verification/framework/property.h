#pragma once

#include "solver/foundation/types.h"

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

namespace verification {

/// How a property is sampled. The seed stands here and nowhere else: RC_PARAMS of the environment is
/// not read, and the same program makes the same cases on every run.
struct Cases {
    int number = 200;
    std::uint64_t seed = 20090101;
};

/// The smallest counterexample that rapidcheck finds to `property`, as text; empty if none.
/// `property` draws its input with `uniform`, `point` or one of rapidcheck's generators, and judges with
/// RC_ASSERT and RC_PRE of <rapidcheck.h>; an exception counts as a counterexample.
/// Throws std::logic_error if RC_PRE discards so much that fewer than `cases.number` remain.
std::string counterexample(const std::function<void()>& property, Cases cases = {});

/// The number of counterexamples that make the claim false, 0 or 1: rapidcheck stops at the first.
/// `.bound = at_most(0, "…"), .measure = [] { return counterexamples([] { … RC_ASSERT(…); }); }`
double counterexamples(const std::function<void()>& property, Cases cases = {});

/// A verdict that is returned would be lost.
template <class Property>
requires(!std::is_void_v<std::invoke_result_t<Property&>>) double counterexamples(
    Property, Cases = {}) = delete;

/// The largest |error| that `error()` returns over all cases, NaN if one of them is NaN.
double worst_error(const std::function<double()>& error, Cases cases = {});

/// Drawn uniformly from [low, high), whatever the size of the case; shrinks towards `low`. Only within
/// a property.
double uniform(double low, double high);

/// Each coordinate drawn uniformly from [low, high).
template <int Dim> plumbline::Vec<Dim> point(double low, double high) {
    plumbline::Vec<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = uniform(low, high);
    return x;
}

}  // namespace verification
