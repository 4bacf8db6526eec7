#pragma once

#include "solver/kernels/kernel.h"
#include "verification/framework/oracle.h"

#include <cmath>
#include <numbers>

namespace verification {

/// Mean of g over the points at distance r from 0. Exact for polynomials on the line, up to degree 31 in
/// the plane, 5 in space (the 6 and 8 points of a Lebedev rule).
template <class G> double mean_over_sphere(double r, G g, std::integral_constant<int, 1>) {
    return 0.5 * (g(plumbline::Vec<1>(r)) + g(plumbline::Vec<1>(-r)));
}
template <class G> double mean_over_sphere(double r, G g, std::integral_constant<int, 2>) {
    constexpr int n = 32;
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        sum += g(plumbline::Vec<2>(r * std::cos(angle), r * std::sin(angle)));
    }
    return sum / n;
}
template <class G> double mean_over_sphere(double r, G g, std::integral_constant<int, 3>) {
    double axes = 0.0, corners = 0.0;
    for (const double sign : {-1.0, 1.0}) {
        for (int d = 0; d < 3; ++d)
            axes += g(plumbline::Vec<3>(sign * r * plumbline::Vec<3>::Unit(d)));
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0})
                corners += g(plumbline::Vec<3>(r / std::sqrt(3.0) * plumbline::Vec<3>(sign, y, z)));
    }
    return axes / 15.0 + corners * 3.0 / 40.0;
}

/// ∫ f(x − y) ω(‖y‖) skew(y) dV over the support: Eq. 2 where skew = 1.
template <plumbline::RadialKernel K, class F, class Skew>
double smoothed(const K& w, F f, const plumbline::Vec<K::dim>& x, Skew skew) {
    constexpr double pi = std::numbers::pi;
    constexpr double surface = K::dim == 1 ? 2.0 : K::dim == 2 ? 2.0 * pi : 4.0 * pi;
    return integrate(
        [&](double r) {
            const auto product = [&](const plumbline::Vec<K::dim>& y) {
                return f(plumbline::Vec<K::dim>(x - y)) * skew(y);
            };
            return w.value(r) * surface * std::pow(r, K::dim - 1) *
                   mean_over_sphere(r, product, std::integral_constant<int, K::dim>{});
        },
        0.0, w.support());
}

}  // namespace verification
