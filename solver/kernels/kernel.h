#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <concepts>
#include <string_view>

namespace plumbline {

/// A radially symmetric kernel ω(r) [m^-dim]: ∫ ω dV = 1 (adams2009 Eq. 8), zero for r ≥ support().
/// Kernels are values: two of them, with different supports, can live side by side.
template <class K>
concept RadialKernel = requires(const K w, double r) {
    { K::name } -> std::convertible_to<std::string_view>;
    { K::dim } -> std::convertible_to<int>;
    { w.support() } -> std::same_as<double>;
    { w.value(r) } -> std::same_as<double>;
    { w.derivative(r) } -> std::same_as<double>;
    { w.second_derivative(r) } -> std::same_as<double>;
};

/// ∇ω(‖x‖) = ω′(r) x / r with r = ‖x‖, and 0 at x = 0.                        adams2009 Eq. 10
template <RadialKernel K> Vec<K::dim> gradient(const K& w, const Vec<K::dim>& x) {
    const double r = x.norm();
    if (r == 0.0) return Vec<K::dim>::Zero();
    return w.derivative(r) / r * x;
}

/// Δω(‖x‖) = ω″(r) + (dim − 1) ω′(r) / r, and at r = 0 its limit dim ω″(0); where the kernel has a kink
/// there, the Laplacian does not exist and is taken as 0, like the gradient.
/// adams2009 Eq. 11 prints Δω = ω″, which is true in one dimension only: erratum 17.
template <RadialKernel K> double laplacian(const K& w, double r) {
    if (r == 0.0) return w.derivative(0.0) == 0.0 ? K::dim * w.second_derivative(0.0) : 0.0;
    return w.second_derivative(r) + (K::dim - 1) * w.derivative(r) / r;
}

}  // namespace plumbline
