#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <cmath>
#include <numbers>

namespace plumbline {

/// With q = r / h: ω(r) = σ (1 − q)⁴ (1 + 4 q) in 2D and 3D, σ (1 − q)³ (1 + 3 q) in 1D, the polynomial of
/// least degree that is C² and positive definite, so that particles do not pair. At the rim C³, in
/// 1D C². Wendland 1995; of the kind named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class WendlandC2 {
public:
    static constexpr std::string_view name = "wendland_c2";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit WendlandC2(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, degree)},
          c1_{h_.factor(Dim == 1 ? -12 * sigma() : -20 * sigma(), Dim, degree - 1, 1)},
          c2_{h_.factor(Dim == 1 ? 12 * sigma() : 20 * sigma(), Dim, degree - 2, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r);
        const Twofold t = difference(h, x);
        if constexpr (Dim == 1) return c0_ * rounded_product(t * t, t) * std::fma(3.0, x, h);
        const Twofold t2 = t * t;
        return c0_ * rounded_product(t2, t2) * std::fma(4.0, x, h);
    }
    double derivative(double r) const {  // −20 σ q (1 − q)³; 1D: −12 σ q (1 − q)²
        const double x = h_.clamp(r), t = h_.scaled() - x;
        return c1_ * x * (Dim == 1 ? t * t : t * t * t);
    }
    double second_derivative(double r) const {  // 20 σ (1 − q)² (4q − 1); 1D: 12 σ (1 − q)(3q − 1)
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x;
        return Dim == 1 ? c2_ * t * (3.0 * x - h) : c2_ * (t * t) * (4.0 * x - h);
    }

private:
    static constexpr int degree = Dim == 1 ? 4 : 5;
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 5 / 4.0L : Dim == 2 ? 7 / pi : 21 / (2 * pi);
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
