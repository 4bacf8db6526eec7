#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// ω(r) = σ (1 − q)³ / q with q = r / h: +∞ at r = 0, so that Shepard's quotient Σ ω f / Σ ω takes the value of a
/// sample as x approaches it, that is, interpolates; not so in one dimension, where 1 / q has no
/// finite integral. Twice continuously differentiable at the rim.
/// adams2009 Sec. 2.1 names the kind; the form is Shepard's inverse distance with compact support.
/// ω(0) = +∞, ω′(0) = −∞, ω″(0) = +∞; ∇ω(0) = 0 and Δω(0) = 0 by the convention for all kernels.
template <int Dim>
requires(Dim == 2 || Dim == 3) class Singular {
public:
    static constexpr std::string_view name = "singular";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Singular(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 2)},
          c1_{h_.factor(-sigma(), Dim, 1, 1)},
          c2_{h_.factor(sigma(), Dim, 0, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {  // σ (1 − q)³ / q
        const double h = h_.scaled(), x = h_.clamp(r);
        const Twofold t = difference(h, x);
        return c0_ * rounded_product(t * t, t) / x;
    }
    double derivative(double r) const {  // −σ (1 − q)² (1 + 2 q) / q²
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x;
        return c1_ * (t / x) * (t / x) * (h + 2.0 * x);
    }
    double second_derivative(double r) const {  // 2 σ (1 − q)(1 + q + q²) / q³
        const double h = h_.scaled(), x = h_.clamp(r), p = h / x;
        return 2.0 * c2_ * ((h - x) / x) * (p * p + p + 1.0);
    }
    /// 3D: 6 σ (1 − q) / q; 2D: σ (1 − q)(1 + q + 4 q²) / q³. Without the point mass of Δ(1/r) at 0.
    double laplacian(double r) const {
        if (r == 0.0) return 0.0;
        const double h = h_.scaled(), x = h_.clamp(r), p = h / x;
        const double factor = Dim == 3 ? 6.0 : p * p + p + 4.0;
        return c2_ * ((h - x) / x) * factor;
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 2 ? 2 / pi : 5 / pi;
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
