#pragma once

#include "solver/foundation/polynomial.h"
#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// With q = r / h: ω(r) = σ (1 − q)⁸ (1 + 8 q + 25 q² + 32 q³) in 2D and 3D, σ (1 − q)⁷ (1 + 7 q + 19 q² + 21 q³)
/// in 1D, the polynomial of least degree that is C⁶ and positive definite. At the rim C⁷, in 1D C⁶.
/// Wendland 1995; of the kind named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class WendlandC6 {
public:
    static constexpr std::string_view name = "wendland_c6";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit WendlandC6(double support) : h_{name, support} {
        constexpr std::array<int, 4> a =
            Dim == 1 ? std::array{1, 7, 19, 21} : std::array{1, 8, 25, 32};
        for (int k = 0; k < 4; ++k) p_[k] = h_.factor(a[k] * sigma(), Dim, power + k);
        c1_ = h_.factor(Dim == 1 ? -6 * sigma() : -22 * sigma(), Dim, power + 2, 1);
        c2_ = h_.factor(Dim == 1 ? 18 * sigma() : 22 * sigma(), Dim, power + 1, 2);
    }

    double support() const { return h_.radius(); }

    double value(double r) const {
        const double x = h_.clamp(r);
        const Twofold t = difference(h_.scaled(), x), t2 = t * t, t4 = t2 * t2;
        return rounded_product(t4, Dim == 1 ? t2 * t : t4) * polynomial(p_, x);
    }
    double derivative(double r) const {
        // −22 σ q (1 − q)⁷ (1 + 7q + 16q²); 1D: −6 σ q (1 − q)⁶ (3 + 18q + 35q²)
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, t2 = t * t, t6 = t2 * t2 * t2;
        return Dim == 1 ? c1_ * x * t6 * (h * (3.0 * h + 18.0 * x) + 35.0 * x * x)
                        : c1_ * x * t6 * t * (h * (h + 7.0 * x) + 16.0 * x * x);
    }
    double second_derivative(double r) const {
        // 22 σ (1 − q)⁶ (160q³ + 15q² − 6q − 1); 1D: 18 σ (1 − q)⁵ (105q³ + 13q² − 5q − 1)
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x, t2 = t * t, t4 = t2 * t2;
        return Dim == 1
                   ? c2_ * t4 * t * (((105.0 * x + 13.0 * h) * x - 5.0 * h * h) * x - h * h * h)
                   : c2_ * t4 * t2 * (((160.0 * x + 15.0 * h) * x - 6.0 * h * h) * x - h * h * h);
    }

private:
    static constexpr int power = Dim == 1 ? 7 : 8;  // of 1 − q
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 55 / 32.0L : Dim == 2 ? 78 / (7 * pi) : 1365 / (64 * pi);
    }

    Support h_;
    std::array<double, 4> p_{};  // σ (1 + 8 q + 25 q² + 32 q³) in scaled lengths
    double c1_, c2_;
};

}  // namespace plumbline
