#include "verification/framework/statistics.h"

#include "solver/foundation/errors.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace verification {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// One level of refinement: mean and variance of log e over its seeds.
struct Level {
    double spacing, log_spacing, mean, variance;
    std::size_t seeds;
};

double student(double degrees_of_freedom) { return gsl_cdf_tdist_Pinv(0.975, degrees_of_freedom); }

Interval around(double centre, double half_width) {
    return {centre - half_width, centre + half_width};
}

Level level_of(double spacing, const std::vector<double>& errors) {
    std::vector<double> logs;
    for (const double e : errors)
        if (std::isfinite(e) && e > 0.0) logs.push_back(std::log(e));
    const auto n = static_cast<double>(logs.size());
    double mean = 0, variance = 0;
    for (const double y : logs) mean += y / n;
    if (logs.size() > 1)
        for (const double y : logs) variance += (y - mean) * (y - mean) / (n - 1);
    return {spacing, std::log(spacing), mean, variance, logs.size()};
}

std::vector<Level> levels_of(std::span<const double> spacing,
                             const std::vector<std::vector<double>>& errors) {
    std::vector<Level> levels;
    for (std::size_t k = 0; k < spacing.size(); ++k) {
        const Level level = level_of(spacing[k], errors[k]);
        if (level.seeds > 0) levels.push_back(level);
    }
    return levels;
}

/// Half of the 95 % interval of Σ leverageₖ · mean log eₖ (Welch, Satterthwaite).
double half_width_by_seeds(std::span<const Level> levels, std::span<const double> leverages) {
    double variance = 0, per_freedom = 0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (levels[k].seeds < 2) continue;
        const auto seeds = static_cast<double>(levels[k].seeds);
        const double share = leverages[k] * leverages[k] * levels[k].variance / seeds;
        variance += share;
        per_freedom += share * share / (seeds - 1.0);
    }
    if (variance == 0.0) return 0.0;
    return student(variance * variance / per_freedom) * std::sqrt(variance);
}

/// Whether the mean square `residual` of the levels from the line is more than the seeds explain.
bool is_lack_of_fit(double residual, const std::vector<Level>& levels) {
    double variance = 0, seeds_left = 0;  // of the mean of a level, pooled
    for (const Level& l : levels) {
        const auto n = static_cast<double>(l.seeds);
        variance += (n - 1.0) * l.variance / n;
        seeds_left += n - 1.0;
    }
    if (seeds_left == 0.0) return residual > 0.0;
    const auto free = static_cast<double>(levels.size()) - 2.0;
    return residual > gsl_cdf_fdist_Pinv(0.95, free, seeds_left) * variance / seeds_left;
}

/// The order and its intervals, of the line through the means of the levels.
void fit_order(const std::vector<Level>& levels, PowerLaw& law) {
    const auto n = static_cast<double>(levels.size());
    double mx = 0, my = 0, sxx = 0, sxy = 0;
    for (const Level& l : levels) mx += l.log_spacing / n, my += l.mean / n;
    for (const Level& l : levels) {
        sxx += (l.log_spacing - mx) * (l.log_spacing - mx);
        sxy += (l.log_spacing - mx) * (l.mean - my);
    }
    law.order = sxy / sxx;

    double residual = 0;
    std::vector<double> leverages;
    for (const Level& l : levels) {
        residual += std::pow(l.mean - my - law.order * (l.log_spacing - mx), 2);
        leverages.push_back((l.log_spacing - mx) / sxx);
    }
    const double misfit = n > 2 ? student(n - 2) * std::sqrt(residual / (n - 2) / sxx) : infinite;
    const double scatter = half_width_by_seeds(levels, leverages);
    law.misfit = around(law.order, misfit);
    law.scatter = around(law.order, scatter);
    law.confidence = around(law.order, std::max(misfit, scatter));
    law.lack_of_fit = n > 2 && is_lack_of_fit(residual / (n - 2), levels);
}

struct FloorFit {
    double floor, residual;
};

/// The best C ≥ 0 and e∞ ≥ 0 of e = C hᵖ + e∞ at a given p, in relative error.
FloorFit fit_floor_at(double p, const std::vector<Level>& levels) {
    double s_aa = 0, s_ab = 0, s_bb = 0, s_a = 0, s_b = 0;  // normal equations of rows (hᵖ, 1) / e
    const double finest = levels.back().log_spacing;
    const auto power = [&](const Level& l) { return std::exp(p * (l.log_spacing - finest)); };
    for (const Level& l : levels) {
        const double a = power(l) / std::exp(l.mean), b = 1.0 / std::exp(l.mean);
        s_aa += a * a, s_ab += a * b, s_bb += b * b, s_a += a, s_b += b;
    }
    const double det = s_aa * s_bb - s_ab * s_ab;
    double c = (s_a * s_bb - s_b * s_ab) / det, floor = (s_aa * s_b - s_ab * s_a) / det;
    if (floor < 0.0) floor = 0.0, c = s_a / s_aa;
    if (c < 0.0) c = 0.0, floor = s_b / s_bb;
    double residual = 0;
    for (const Level& l : levels)
        residual += std::pow((c * power(l) + floor) / std::exp(l.mean) - 1.0, 2);
    return {floor, residual};
}

double fit_floor(const std::vector<Level>& levels) {
    constexpr double lowest = 0.25, highest = 6.0, step = 0.05;
    double best_p = lowest;
    FloorFit best = fit_floor_at(lowest, levels);
    const auto scan = [&](double from, double to, double by) {
        for (double p = std::max(from, lowest); p <= std::min(to, highest); p += by)
            if (const FloorFit fit = fit_floor_at(p, levels); fit.residual < best.residual)
                best = fit, best_p = p;
    };
    scan(lowest, highest, step);
    for (double by = step / 10; by > 1e-7; by /= 10) scan(best_p - 10 * by, best_p + 10 * by, by);
    return best.floor;
}

/// 95 % interval of the floor: each seed left out in turn, on all levels at once.
Interval jackknife_floor(double floor, std::span<const double> spacing,
                         const std::vector<std::vector<double>>& errors) {
    std::size_t seeds = errors.front().size();
    for (const auto& level : errors) seeds = std::min(seeds, level.size());
    if (seeds < 2) return {floor, floor};
    std::vector<double> floors;
    for (std::size_t seed = 0; seed < seeds; ++seed) {
        auto rest = errors;
        for (auto& level : rest) level.erase(level.begin() + static_cast<std::ptrdiff_t>(seed));
        const auto levels = levels_of(spacing, rest);
        if (levels.size() >= 4) floors.push_back(fit_floor(levels));
    }
    const auto n = static_cast<double>(floors.size());
    if (floors.size() < 2) return {0.0, floor};
    double mean = 0, squares = 0;
    for (const double f : floors) mean += f / n;
    for (const double f : floors) squares += (f - mean) * (f - mean);
    const Interval free = around(floor, student(n - 1) * std::sqrt(squares * (n - 1) / n));
    return {std::max(0.0, free.low), free.high};
}

void fit_grid_convergence(PowerLaw& law, std::optional<double> formal_order) {
    law.grid_convergence_index = law.safety_factor = nan;
    const auto& e = law.error;
    const std::size_t n = e.size();
    if (n < 3) return;
    law.safety_factor = 3.0;
    if (!std::ranges::is_sorted(e, std::greater{})) {
        const auto [low, high] = std::ranges::minmax(e);
        law.grid_convergence_index = law.safety_factor * 0.5 * (high - low);
        return;
    }
    const double last = law.local_orders.back(), formal = formal_order.value_or(law.order);
    if (0.5 <= last && last <= 2.0 * formal) law.safety_factor = 1.25;
    const double ratio = law.spacing[n - 2] / law.spacing[n - 1];
    law.grid_convergence_index =
        law.safety_factor * (e[n - 2] - e[n - 1]) / (std::pow(ratio, std::max(last, 0.5)) - 1.0);
}

void require_levels(std::span<const double> spacing,
                    const std::vector<std::vector<double>>& errors) {
    using std::to_string;
    if (spacing.size() != errors.size())
        throw plumbline::InvalidInput("fit_power_law: expected the errors of " +
                                      to_string(spacing.size()) + " levels, found " +
                                      to_string(errors.size()));
    for (std::size_t k = 0; k < spacing.size(); ++k)
        if (!(spacing[k] > 0.0 && (k == 0 || spacing[k] < spacing[k - 1])))
            throw plumbline::InvalidInput(
                "fit_power_law: expected a positive spacing that falls "
                "from level to level, found " +
                to_string(spacing[k]) + " at level " + to_string(k));
}
}  // namespace

double median(std::vector<double> values) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (values.empty()) return nan;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

PowerLaw fit_power_law(std::span<const double> spacing,
                       const std::vector<std::vector<double>>& errors,
                       std::optional<double> formal_order) {
    require_levels(spacing, errors);
    const std::vector<Level> levels = levels_of(spacing, errors);
    if (levels.size() < 2)
        throw plumbline::InvalidInput(
            "fit_power_law: expected positive finite errors on at least 2 levels, found " +
            std::to_string(levels.size()));

    PowerLaw law{};
    fit_order(levels, law);
    for (const Level& l : levels) {
        law.spacing.push_back(l.spacing);
        law.error.push_back(std::exp(l.mean));
    }
    for (std::size_t k = 1; k < levels.size(); ++k)
        law.local_orders.push_back((levels[k - 1].mean - levels[k].mean) /
                                   (levels[k - 1].log_spacing - levels[k].log_spacing));
    const double step = 1.0 / (levels[levels.size() - 2].log_spacing - levels.back().log_spacing);
    law.last_step = around(law.local_orders.back(),
                           half_width_by_seeds(std::span(levels).last(2), std::array{step, -step}));
    if (levels.size() >= 4 && law.order > -flat_order) {
        law.floor = fit_floor(levels);
        law.floor_confidence = jackknife_floor(law.floor, spacing, errors);
    }
    fit_grid_convergence(law, formal_order);
    return law;
}

}  // namespace verification
