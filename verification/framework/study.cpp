#include "verification/framework/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

namespace verification {

namespace {
/// A floor counts as reached when it makes up more than half of the finest error.
constexpr double saturated_share = 0.5;
/// Floors of different methods that differ by less are one floor.
constexpr double same_floor = 1.1;
constexpr std::size_t fewest_levels = 4;

bool is_flat(const PowerLaw& fit) {
    return -flat_order < fit.confidence.low && fit.confidence.high < flat_order;
}

bool is_saturated(const PowerLaw& fit) {
    if (is_flat(fit)) return true;
    const double steepest = std::ranges::max(fit.local_orders);
    return fit.floor > saturated_share * fit.error.back() && fit.floor_confidence.low > 0.0 &&
           fit.local_orders.back() < std::max(0.5 * steepest, flat_order);
}

Verdict judge_order(const Bound& bound, const PowerLaw& fit) {
    const Interval& order = fit.confidence;
    if (bound.holds(order.low) && bound.holds(order.high)) {
        const bool leaves = fit.last_step.high < bound.low || fit.last_step.low > bound.high;
        return leaves ? Verdict::not_in_asymptotic_range : Verdict::verified;
    }
    if (order.high < bound.low || order.low > bound.high) return Verdict::failed;
    return fit.lack_of_fit ? Verdict::not_in_asymptotic_range : Verdict::inconclusive;
}

Verdict judge_saturation(const PowerLaw& fit) {
    if (is_saturated(fit)) return Verdict::verified;
    const bool falls =
        fit.confidence.low > 0.0 && fit.floor_confidence.high < saturated_share * fit.error.back();
    const bool grows = fit.confidence.high < 0.0;
    return falls || grows ? Verdict::failed : Verdict::inconclusive;
}

Verdict judge_sound(const Study::Series& series, const PowerLaw& fit) {
    if (fit.error.size() < fewest_levels) return Verdict::inconclusive;
    if (series.saturates) return judge_saturation(fit);
    if (is_saturated(fit)) return Verdict::saturated;
    return judge_order(series.order, fit);
}

std::optional<double> formal_order(const Study::Series& series) {
    if (series.saturates) return {};
    return 0.5 * (series.order.low + series.order.high);
}

/// A method that answers on fewer than two levels has no order: NaN.
PowerLaw fit_if_possible(const std::vector<double>& spacing,
                         const std::vector<std::vector<double>>& errors,
                         const Study::Series& series) {
    const auto answered = std::ranges::count_if(errors, [](const std::vector<double>& level) {
        return std::ranges::any_of(level, [](double e) { return std::isfinite(e) && e > 0.0; });
    });
    if (answered >= 2) return fit_power_law(spacing, errors, formal_order(series));
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    PowerLaw none{};
    none.order = none.grid_convergence_index = none.safety_factor = unknown;
    none.confidence = none.misfit = none.scatter = {unknown, unknown};
    return none;
}

int count_failures(const std::vector<std::vector<double>>& errors) {
    int failures = 0;
    for (const auto& level : errors)
        failures += static_cast<int>(
            std::ranges::count_if(level, [](double e) { return !std::isfinite(e); }));
    return failures;
}

void run_levels(const Study& study, StudyResult& result) {
    std::vector<SeriesResult> all;
    for (const Study::Series& s : study.series)
        all.push_back({s.name, s.order, s.saturates, {}, {}, Verdict::failed, s.sabotaged});
    for (const double spacing : result.spacing) {
        for (SeriesResult& s : all) s.errors.emplace_back();
        for (int seed = 1; seed <= study.seeds; ++seed) {
            const auto errors = study.errors(spacing, static_cast<std::uint64_t>(seed));
            if (errors.size() != all.size())
                throw std::logic_error(study.id + ": one error per series expected");
            for (std::size_t k = 0; k < all.size(); ++k) all[k].errors.back().push_back(errors[k]);
        }
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].failures = count_failures(all[k].errors);
        all[k].fit = fit_if_possible(result.spacing, all[k].errors, study.series[k]);
        all[k].verdict = judge(study.series[k], all[k].fit);
    }
    result.series = std::move(all);
}

void warn_of_common_floor(StudyResult& result) {
    const auto floor = common_floor(result.series);
    if (!floor) return;
    result.warning = "all methods flatten at the same error, " + std::to_string(*floor) +
                     ": the reference is too coarse to tell them apart";
    for (SeriesResult& s : result.series) s.verdict = Verdict::inconclusive;
}
}  // namespace

Verdict judge(const Study::Series& series, const PowerLaw& fit) {
    const Verdict verdict = judge_sound(series, fit);
    if (!series.sabotaged) return verdict;
    switch (verdict) {
        case Verdict::verified:
            return Verdict::toothless;
        case Verdict::failed:
        case Verdict::saturated:
            return Verdict::verified;
        default:
            return verdict;
    }
}

std::optional<double> common_floor(const std::vector<SeriesResult>& series) {
    std::vector<double> floors;
    for (const SeriesResult& s : series) {
        if (s.sabotaged) continue;
        if (s.fit.error.size() < fewest_levels || !is_saturated(s.fit)) return {};
        floors.push_back(s.fit.floor);
    }
    if (floors.size() < 2) return {};
    const auto [low, high] = std::ranges::minmax(floors);
    if (!(low > 0.0) || high > same_floor * low) return {};
    return median(floors);
}

StudyResult run(const Study& study, Effort effort) {
    const auto start = std::chrono::steady_clock::now();
    StudyResult result{study, study.spacing, study.seeds, {}, 0, {}, {}};
    if (effort == Effort::quick)
        result.spacing.resize(
            std::min(result.spacing.size(), static_cast<std::size_t>(study.quick_levels)));
    try {
        run_levels(study, result);
        warn_of_common_floor(result);
    } catch (const std::exception& e) {
        result.error = e.what();
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace verification
