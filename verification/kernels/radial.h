#pragma once

#include "solver/kernels/kernel.h"
#include "verification/framework/oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verification {

/// Surface of the sphere of radius r in `dim` dimensions; in 1D the two ends of the interval.
inline double sphere(int dim, double r) {
    constexpr double pi = std::numbers::pi;
    return dim == 1 ? 2.0 : dim == 2 ? 2 * pi * r : 4 * pi * r * r;
}

/// Where a printed formula changes its branch, as fractions of h; kernels of one branch have none.
template <class F> std::vector<double> knots() {
    if constexpr (requires { F::knots; })
        return {std::begin(F::knots), std::end(F::knots)};
    else
        return {};
}

/// ∫ g(‖x‖) dV over the ball of radius h; `knots` as fractions of h.
inline double integrate_radially(int dim, double h, const std::function<double(double)>& g,
                                 std::vector<double> knots = {}) {
    for (double& knot : knots) knot *= h;
    return integrate([&](double r) { return g(r) * sphere(dim, r); }, 0.0, h, std::move(knots));
}

/// ∫ ω(‖x‖) ‖x‖ᵖ dV.
template <plumbline::RadialKernel K>
double moment(const K& w, int p, std::vector<double> knots = {}) {
    const auto integrand = [&](double r) { return w.value(r) * std::pow(r, p); };
    return integrate_radially(K::dim, w.support(), integrand, std::move(knots));
}

/// ∫ q^(Dim + 1) P dq / (Dim ∫ q^(Dim − 1) P dq) over [0, 1]: the second moment of one axis of the kernel
/// P(q), to 50 digits where P is a polynomial between its knots.
template <int Dim>
Real50 second_moment_of(const std::function<Real50(const Real50&)>& P,
                        std::vector<Real50> knots = {}) {
    const auto weighted = [&](int power) {
        const auto integrand = [&](const Real50& q) -> Real50 { return P(q) * pow(q, power); };
        return integrate_polynomial(integrand, 0, 1, knots);
    };
    return weighted(Dim + 1) / (Dim * weighted(Dim - 1));
}

/// The largest jump of ω, ω′ or ω″ of `w` across `knot`, each against its size.
template <plumbline::RadialKernel K> double jump_across(const K& w, double knot) {
    const double inside = std::nextafter(knot, 0.0);
    return std::max(
        {std::abs(w.value(knot) - w.value(inside)) / w.value(0.0),
         std::abs(w.derivative(knot) - w.derivative(inside)) / std::abs(w.derivative(knot)),
         std::abs(w.second_derivative(knot) - w.second_derivative(inside)) /
             std::abs(w.second_derivative(0.0))});
}

}  // namespace verification
