#include "verification/framework/property.h"

#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace verification {

namespace {
/// rapidcheck's own listeners write to the terminal.
struct Silent : rc::detail::TestListener {
    void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
    void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
    void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};
}  // namespace

std::string counterexample(const std::function<void()>& property, Cases cases) {
    rc::detail::TestParams params;
    params.seed = cases.seed;
    params.maxSuccess = cases.number;
    Silent silent;
    const auto result =
        rc::detail::checkProperty(rc::detail::toProperty(property), {}, params, silent, {});
    if (result.is<rc::detail::SuccessResult>()) return {};
    if (!result.is<rc::detail::FailureResult>())
        throw std::logic_error("property: too many cases discarded");
    const auto& failure = result.get<rc::detail::FailureResult>();
    std::string text = failure.description;
    for (const auto& [type, value] : failure.counterExample) text += "\n" + type + " " + value;
    return text;
}

double counterexamples(const std::function<void()>& property, Cases cases) {
    return counterexample(property, cases).empty() ? 0.0 : 1.0;
}

double worst_error(const std::function<double()>& error, Cases cases) {
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

double uniform(double low, double high) {
    constexpr std::int64_t steps = std::int64_t{1} << 53;
    const auto integers = rc::gen::inRange<std::int64_t>(0, steps);
    return *rc::gen::map(rc::gen::resize(rc::kNominalSize, integers), [=](std::int64_t k) {
        return low + (high - low) * (static_cast<double>(k) / static_cast<double>(steps));
    });
}

}  // namespace verification
