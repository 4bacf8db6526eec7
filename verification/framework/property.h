#pragma once

#include "solver/foundation/types.h"

#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace verification {

/// How a property is sampled. The seed stands here and nowhere else: RC_PARAMS of the environment is
/// not read, and the same program makes the same cases on every run.
struct Cases {
    int number = 200;
    std::uint64_t seed = 20090101;
};

/// The smallest counterexample that rapidcheck finds to `property`, as text; empty if none.
/// `property` draws its input with `*generator` and judges with RC_ASSERT, RC_PRE or a bool result;
/// an exception counts as a counterexample.
/// Throws std::logic_error if RC_PRE discards so much that fewer than `cases.number` remain.
template <class Property> std::string counterexample(Property property, Cases cases = {});

/// The number of counterexamples that make the claim false, 0 or 1: rapidcheck stops at the first.
/// `.bound = at_most(0, "…"), .measure = [] { return counterexamples([] { … RC_ASSERT(…); }); }`
template <class Property> double counterexamples(Property property, Cases cases = {}) {
    return counterexample(property, cases).empty() ? 0.0 : 1.0;
}

/// The largest |error| that `error()` returns over all cases, NaN if one of them is NaN.
template <class Error> double worst_error(Error error, Cases cases = {});

/// Uniform in [low, high), whatever the size of the case; shrinks towards `low`.
inline rc::Gen<double> uniform(double low, double high) {
    constexpr std::int64_t steps = std::int64_t{1} << 53;
    const auto integers = rc::gen::inRange<std::int64_t>(0, steps);
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, integers), [=](std::int64_t k) {
        return low + (high - low) * (static_cast<double>(k) / static_cast<double>(steps));
    });
}

/// Each coordinate uniform in [low, high).
template <int Dim> rc::Gen<plumbline::Vec<Dim>> point(double low, double high) {
    return rc::gen::exec([=] {
        plumbline::Vec<Dim> x;
        for (int d = 0; d < Dim; ++d) x[d] = *uniform(low, high);
        return x;
    });
}

namespace detail {
/// rapidcheck's own listeners write to the terminal.
struct Silent : rc::detail::TestListener {
    void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
    void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
    void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};
}  // namespace detail

template <class Property> std::string counterexample(Property property, Cases cases) {
    rc::detail::TestParams params;
    params.seed = cases.seed;
    params.maxSuccess = cases.number;
    detail::Silent silent;
    const auto result =
        rc::detail::checkProperty(rc::detail::toProperty(property), {}, params, silent, {});
    if (result.template is<rc::detail::SuccessResult>()) return {};
    if (!result.template is<rc::detail::FailureResult>())
        throw std::logic_error("property: too many cases discarded");
    const auto& failure = result.template get<rc::detail::FailureResult>();
    std::string text = failure.description;
    for (const auto& [type, value] : failure.counterExample) text += "\n" + type + " " + value;
    return text;
}

template <class Error> double worst_error(Error error, Cases cases) {
    double worst = 0.0;
    const std::string failure = counterexample(
        [&] {
            const double e = std::abs(error());
            if (!(e <= worst)) worst = e;  // also NaN, which then stays: nothing is <= NaN ...
            RC_ASSERT(!std::isnan(e));     // ... and ends the search
        },
        cases);
    return failure.empty() ? worst : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace verification
