#include "verification/framework/statistics.h"

#include "solver/foundation/errors.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace verification {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Line {
    double slope, intercept, slope_error;  // slope_error: standard error from the residuals
    int degrees_of_freedom;
};

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mx = 0, my = 0, sxx = 0, sxy = 0, residual = 0;
    for (std::size_t k = 0; k < x.size(); ++k) mx += x[k] / n, my += y[k] / n;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sxx += (x[k] - mx) * (x[k] - mx);
        sxy += (x[k] - mx) * (y[k] - my);
    }
    const double slope = sxy / sxx, intercept = my - slope * mx;
    for (std::size_t k = 0; k < x.size(); ++k)
        residual += std::pow(y[k] - intercept - slope * x[k], 2);
    const int dof = static_cast<int>(x.size()) - 2;
    return {slope, intercept, dof > 0 ? std::sqrt(residual / dof / sxx) : nan, dof};
}

struct Level {
    double spacing, error;
};

/// e∞ ≥ 0 of e = C hᵖ + e∞ with C ≥ 0, minimising the relative residuals, over p in [1/4, 6].
double fit_floor(const std::vector<Level>& levels) {
    double best_residual = std::numeric_limits<double>::infinity(), best_floor = 0.0;
    for (double p = 0.25; p <= 6.0; p += 0.05) {
        double s_aa = 0, s_ab = 0, s_bb = 0, s_a = 0, s_b = 0;  // normal equations, rows (hᵖ, 1) / e
        for (const Level& l : levels) {
            const double a = std::pow(l.spacing, p) / l.error, b = 1.0 / l.error;
            s_aa += a * a, s_ab += a * b, s_bb += b * b, s_a += a, s_b += b;
        }
        const double det = s_aa * s_bb - s_ab * s_ab;
        double c = (s_a * s_bb - s_b * s_ab) / det, floor = (s_aa * s_b - s_ab * s_a) / det;
        if (floor < 0.0) floor = 0.0, c = s_a / s_aa;
        if (c < 0.0) c = 0.0, floor = s_b / s_bb;
        double residual = 0;
        for (const Level& l : levels)
            residual += std::pow((c * std::pow(l.spacing, p) + floor) / l.error - 1.0, 2);
        if (residual < best_residual) best_residual = residual, best_floor = floor;
    }
    return best_floor;
}

/// Roache's index of the finest level against the one before, safety factor 1.25, or 3 where the
/// observed order of the last three levels is outside [0.5, 2] times the fitted one.
double grid_convergence_index(const std::vector<Level>& levels, double order,
                              const std::vector<double>& local) {
    if (levels.size() < 3 || !(order > 0.0)) return nan;
    const double last = local.back();
    const double safety = last > 0.5 * order && last < 2.0 * order ? 1.25 : 3.0;
    const Level &fine = levels.back(), &coarse = levels[levels.size() - 2];
    const double ratio = coarse.spacing / fine.spacing;
    return safety * std::abs(coarse.error - fine.error) / (std::pow(ratio, order) - 1.0);
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
                       const std::vector<std::vector<double>>& errors) {
    std::vector<double> log_h, log_e;
    std::vector<Level> levels;
    for (std::size_t k = 0; k < spacing.size(); ++k) {
        for (const double e : errors[k])
            if (std::isfinite(e) && e > 0.0)
                log_h.push_back(std::log(spacing[k])), log_e.push_back(std::log(e));
        const double middle = median(errors[k]);
        if (std::isfinite(middle) && middle > 0.0) levels.push_back({spacing[k], middle});
    }
    if (levels.size() < 2)
        throw plumbline::InvalidInput(
            "fit_power_law: expected positive finite errors on at least 2 levels, found " +
            std::to_string(levels.size()));

    PowerLaw law{};
    const Line line = fit_line(log_h, log_e);
    law.order = line.slope;
    const double t = line.degrees_of_freedom > 0
                         ? gsl_cdf_tdist_Pinv(0.975, line.degrees_of_freedom)
                         : nan;
    law.confidence = {line.slope - t * line.slope_error, line.slope + t * line.slope_error};
    for (std::size_t k = 1; k < levels.size(); ++k)
        law.local_orders.push_back(std::log(levels[k - 1].error / levels[k].error) /
                                   std::log(levels[k - 1].spacing / levels[k].spacing));
    const bool diverges = law.confidence.high < -0.1;
    law.floor = levels.size() >= 4 && !diverges ? fit_floor(levels) : 0.0;
    law.grid_convergence_index = grid_convergence_index(levels, law.order, law.local_orders);
    return law;
}

}  // namespace verification
