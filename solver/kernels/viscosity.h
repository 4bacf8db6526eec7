#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <cmath>
#include <numbers>

namespace plumbline {

/// The kernel whose Laplacian is a cone, hence never negative, which keeps viscosity forces dissipative:
/// dim 3: ω(r) = σ (−q³/2 + q² + 1/(2q) − 1), Δω = 6 σ (1 − q) / h²; Müller et al. 2003
/// dim 2: ω(r) = σ (q²/4 − q³/9 − ln(q)/6 − 5/36), Δω = σ (1 − q) / h²
/// with q = r / h. Singular at the centre: ω(0) = +∞, ω′(0) = −∞, ω″(0) = +∞, but Δω(0) is finite; the
/// point mass of the Laplacian there is left out. Twice continuously differentiable at the rim.
/// In 2D the terms of ω cancel towards the rim: its error is 1e-15 σ/h² there, not 1e-15 ω.
template <int Dim>
requires(Dim == 2 || Dim == 3) class Viscosity {
public:
    static constexpr std::string_view name = "viscosity";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Viscosity(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, Dim == 3 ? 3 : 0)},
          c1_{h_.factor(-sigma(), Dim, 2, 1)},
          c2_{h_.factor(sigma(), Dim, 1, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {  // dim 3: σ (1 − q)³ (1 + q) / (2 q)
        const double h = h_.scaled(), x = h_.clamp(r);
        if constexpr (Dim == 2) {
            const double q = x / h;
            return c0_ * (q * q * (1.0 / 4.0 - q / 9.0) - std::log(q) / 6.0 - 5.0 / 36.0);
        }
        const Twofold t = difference(h, x);
        return c0_ * rounded_product(t * t, t) * (h + x) / (2.0 * x);
    }
    /// dim 3: −σ (1 − q)² (1 + 2q + 3q²) / (2q²), dim 2: −σ (1 − q)² (1 + 2q) / (6q)
    double derivative(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, p = h / x;
        if constexpr (Dim == 2) return c1_ * (t * t) * (p + 2.0) / 6.0;
        return c1_ * (t * t) * (p * p + 2.0 * p + 3.0) / 2.0;
    }
    /// dim 3: σ (1 − q)(1 + q + q² + 3q³) / q³, dim 2: σ (1 − q)(1 + q + 4q²) / (6q²)
    double second_derivative(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, p = h / x;
        if constexpr (Dim == 2) return c2_ * t * (p * p + p + 4.0) / 6.0;
        return c2_ * t * (p * p * p + p * p + p + 3.0);
    }
    double laplacian(double r) const {
        return (Dim == 3 ? 6.0 : 1.0) * c2_ * (h_.scaled() - h_.clamp(r));
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 2 ? 40 / pi : 15 / (2 * pi);
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
