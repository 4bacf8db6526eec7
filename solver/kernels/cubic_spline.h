#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <cmath>
#include <numbers>

namespace plumbline {

/// The cubic B-spline with q = r / h: ω(r) = σ (1 − 6q² + 6q³) for q ≤ 1/2, 2σ (1 − q)³ beyond; twice
/// continuously differentiable everywhere. h is the whole support: 2 h of the usual SPH notation.
/// Monaghan & Lattanzio 1985; of the kind named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class CubicSpline {
public:
    static constexpr std::string_view name = "cubic_spline";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit CubicSpline(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 3)},
          c1_{h_.factor(6 * sigma(), Dim, 2, 1)},
          c2_{h_.factor(12 * sigma(), Dim, 1, 2)} {}

    double support() const { return h_.radius(); }

    /// The inner branch is expanded around the knot, in m = 1/2 − q, where it does not cancel:
    /// 1/4 + 3/2 m + 3 m² − 6 m³.
    double value(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r), m = 0.5 * h - x;
        if (m > 0.0)
            return c0_ * std::fma(m, std::fma(m, std::fma(-6.0, m, 3.0 * h), 1.5 * h * h),
                                  0.25 * h * h * h);
        const double t = h - x;
        return 2.0 * c0_ * (t * t * t);
    }
    double derivative(double r) const {  // 6σ (3q² − 2q), −6σ (1 − q)²
        const double h = h_.scaled(), x = h_.clamp(r), t = h - x;
        return c1_ * (x < 0.5 * h ? x * (3.0 * x - 2.0 * h) : -(t * t));
    }
    double second_derivative(double r) const {  // 12σ (3q − 1), 12σ (1 − q)
        const double h = h_.scaled(), x = h_.clamp(r);
        return c2_ * (x < 0.5 * h ? 3.0 * x - h : h - x);
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 4 / 3.0L : Dim == 2 ? 40 / (7 * pi) : 8 / pi;
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
