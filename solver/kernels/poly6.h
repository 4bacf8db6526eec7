#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <cmath>
#include <numbers>

namespace plumbline {

/// ω(r) = σ (1 − q²)³ with q = r / h; smooth inside, twice continuously differentiable at the rim, never
/// negative, flat at the centre (so that close particles hardly repel each other).
/// adams2009 Eqs. 86–88 (dim 3) and 89–91 (dim 2), there from Müller et al. 2003.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class Poly6 {
public:
    static constexpr std::string_view name = "poly6";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Poly6(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 6)},
          c1_{h_.factor(-6 * sigma(), Dim, 5, 1)},
          c2_{h_.factor(6 * sigma(), Dim, 4, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {  // σ (1 − q²)³, Eqs. 86, 89
        const double h = h_.scaled(), x = h_.clamp(r);
        const Twofold s = difference(h, x) * sum(h, x);
        const double s2 = s.value * s.value;
        return c0_ * std::fma(s2, s.value, 3.0 * s2 * s.rest);  // (s + rest)³ but for rest²
    }
    double derivative(double r) const {  // −6 σ q (1 − q²)², Eqs. 87, 90
        const double h = h_.scaled(), x = h_.clamp(r), s = (h - x) * (h + x);
        return c1_ * x * (s * s);
    }
    double second_derivative(double r) const {  // 6 σ (1 − q²)(5 q² − 1), Eqs. 88, 91
        const double h = h_.scaled(), x = h_.clamp(r), s = (h - x) * (h + x);
        return c2_ * s * (5.0 * x * x - h * h);
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 35 / 32.0L : Dim == 2 ? 4 / pi : 315 / (64 * pi);
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
