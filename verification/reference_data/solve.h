#pragma once

#include <functional>
#include <vector>

namespace verification {

/// The root of f in [low, high], where f changes its sign, to 1e-15 relative (GSL, Brent's method).
/// Throws std::runtime_error, with GSL's reason, if f does not change its sign.
double root(const std::function<double(double)>& f, double low, double high);

/// y at `end` of y′ = rates(t, y) with y(0) = start (GSL, Prince-Dormand of order 8 and 9, tolerance
/// 1e-14 |y| + 1e-17 per step). Throws std::runtime_error if the steps become too small.
std::vector<double> solve_ode(
    const std::function<void(double t, const double y[], double rates[])>& rates,
    std::vector<double> start, double end);

}  // namespace verification
