#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <functional>
#include <vector>

namespace verification {

/// 50 decimal digits: formulas written with it serve as the truth for double precision.
using Real50 = boost::multiprecision::cpp_bin_float_50;

/// |computed − exact| in units in the last place of `exact`, rounded to double: 0.5 is the best
/// possible. Below the smallest normal number the unit is 2⁻¹⁰⁷⁴.
double ulp_error(double computed, const Real50& exact);

/// ∫ₐᵇ f dx by GSL, panel by panel between the sorted `breakpoints` inside (a, b), which belong where f
/// has a kink. Relative accuracy 1e-13, or as far as rounding lets it come; polynomials up to
/// degree 31 are exact to rounding. Singularities are allowed at ends of panels, if integrable.
/// Throws std::runtime_error, with GSL's reason, where the integral does not converge.
double integrate(const std::function<double(double)>& f, double a, double b,
                 std::vector<double> breakpoints = {});

/// ∫ₐᵇ f dx by Gauss's rule of 30 points in each panel: exact to all 50 digits where f is a polynomial
/// of degree up to 59 between breakpoints.
Real50 integrate_polynomial(const std::function<Real50(const Real50&)>& f, const Real50& a,
                            const Real50& b, std::vector<Real50> breakpoints = {});

}  // namespace verification
