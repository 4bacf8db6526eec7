#pragma once

#include "solver/foundation/polynomial.h"
#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// With q = r / h: ω(r) = σ (1 − q)⁶ (1 + 6 q + 35/3 q²) in 2D and 3D, σ (1 − q)⁵ (1 + 5 q + 8 q²) in 1D, the
/// polynomial of least degree that is C⁴ and positive definite. At the rim C⁵, in 1D C⁴.
/// Wendland 1995; of the kind named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class WendlandC4 {
public:
    static constexpr std::string_view name = "wendland_c4";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit WendlandC4(double support) : h_{name, support} {
        if constexpr (Dim == 1) {
            p_ = {h_.factor(sigma(), 1, 5), h_.factor(5 * sigma(), 1, 6),
                  h_.factor(8 * sigma(), 1, 7)};
            c1_ = h_.factor(-14 * sigma(), Dim, 6, 1);
            c2_ = h_.factor(14 * sigma(), Dim, 5, 2);
        } else {
            p_ = {h_.factor(sigma(), Dim, 6), h_.factor(6 * sigma(), Dim, 7),
                  h_.factor(35 * sigma() / 3, Dim, 8)};
            c1_ = h_.factor(-56 * sigma() / 3, Dim, 7, 1);
            c2_ = h_.factor(56 * sigma() / 3, Dim, 6, 2);
        }
    }

    double support() const { return h_.radius(); }

    double value(double r) const {
        const double x = h_.clamp(r);
        const Twofold t = difference(h_.scaled(), x), t2 = t * t;
        const double t4 = rounded_product(t2, t2);
        return t4 * (Dim == 1 ? t.value : t2.value) * polynomial(p_, x);
    }
    double derivative(
        double r) const {  // −56/3 σ q (1 − q)⁵ (1 + 5q); 1D: −14 σ q (1 − q)⁴ (1 + 4q)
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, t2 = t * t, t4 = t2 * t2;
        return Dim == 1 ? c1_ * x * t4 * (h + 4.0 * x) : c1_ * x * t4 * t * (h + 5.0 * x);
    }
    double second_derivative(double r) const {
        // 56/3 σ (1 − q)⁴ (35q² − 4q − 1); 1D: 14 σ (1 − q)³ (24q² − 3q − 1)
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, t2 = t * t;
        return Dim == 1 ? c2_ * t2 * t * ((24.0 * x - 3.0 * h) * x - h * h)
                        : c2_ * (t2 * t2) * ((35.0 * x - 4.0 * h) * x - h * h);
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 3 / 2.0L : Dim == 2 ? 9 / pi : 495 / (32 * pi);
    }

    Support h_;
    std::array<double, 3> p_{};  // σ (1 + 6 q + 35/3 q²) in scaled lengths
    double c1_, c2_;
};

}  // namespace plumbline
