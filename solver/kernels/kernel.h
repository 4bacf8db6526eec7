#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <concepts>
#include <string_view>

namespace plumbline {

/// A radially symmetric kernel ω(r) [m^-dim]: ∫ ω dV = 1 (adams2009 Eq. 8), zero for r ≥ support().
/// Kernels are values: two of them, with different supports, can live side by side.
/// `value`, `derivative` and `second_derivative` take r ≥ 0 [m]; NaN gives NaN. The derivatives at
/// r = 0 are the limits from outside, also where the kernel has a kink or a singularity there.
template <class K>
concept RadialKernel = requires(const K w, double r) {
    { K::name } -> std::convertible_to<std::string_view>;
    { K::dim } -> std::convertible_to<int>;
    { w.support() } -> std::same_as<double>;
    { w.value(r) } -> std::same_as<double>;
    { w.derivative(r) } -> std::same_as<double>;
    { w.second_derivative(r) } -> std::same_as<double>;
};

/// ∇ω(‖x‖) = ω′(r) x / r with r = ‖x‖, and 0 at x = 0, also for kernels with a kink or a singularity
/// there: no direction is better than another.                                 adams2009 Eq. 10
template <RadialKernel K> Vec<K::dim> gradient(const K& w, const Vec<K::dim>& x) {
    const double r = x.norm();
    if (r == 0.0) return Vec<K::dim>::Zero();
    return w.derivative(r) / r * x;
}

/// Nearer to the centre than this fraction of the support counts as the centre, since quotients of
/// numbers near the smallest double mean nothing.
inline constexpr double centre_fraction = 1e-100;

/// ω″(0) of a smooth kernel; 0 where there is a kink or a singularity, and no curvature.
template <RadialKernel K> double curvature_at_centre(const K& w) {
    return w.derivative(0.0) == 0.0 ? w.second_derivative(0.0) : 0.0;
}

/// Δω(‖x‖) = ω″(r) + (dim − 1) ω′(r) / r, and at r = 0 its limit dim ω″(0); where the kernel has a kink or a
/// singularity there, the Laplacian does not exist and is taken as 0, like the gradient. A kernel
/// where the sum cancels brings its own `laplacian(r)`.
/// adams2009 Eq. 11 prints Δω = ω″, which is true in one dimension only: erratum 17.
template <RadialKernel K> double laplacian(const K& w, double r) {
    if constexpr (requires { w.laplacian(r); }) {
        return w.laplacian(r);
    } else {
        if (r <= centre_fraction * w.support()) return K::dim * curvature_at_centre(w);
        return w.second_derivative(r) + (K::dim - 1) * w.derivative(r) / r;
    }
}

/// ∇∇ω(‖x‖) = (ω″ − ω′/r) x xᵀ/r² + (ω′/r) I; at x = 0 as for the Laplacian, its trace.
template <RadialKernel K> Mat<K::dim> hessian(const K& w, const Vec<K::dim>& x) {
    const double r = x.norm();
    if (r <= centre_fraction * w.support()) return curvature_at_centre(w) * Mat<K::dim>::Identity();
    const Vec<K::dim> n = x / r;
    const double slope = w.derivative(r) / r;
    return (w.second_derivative(r) - slope) * n * n.transpose() + slope * Mat<K::dim>::Identity();
}

}  // namespace plumbline
