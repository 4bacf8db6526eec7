#pragma once

#include "solver/foundation/polynomial.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// The quintic B-spline with s = 3 r / h, a₊ = max(a, 0):
/// ω(r) = σ ((3 − s)₊⁵ − 6 (2 − s)₊⁵ + 15 (1 − s)₊⁵); four times continuously differentiable everywhere.
/// h is the whole support: 3 h of the usual SPH notation. Schoenberg 1946; in SPH, Morris et al. 1997.
/// The polynomial of each of the three branches is expanded around its outer knot, in the distance m
/// from it, where its terms do not cancel.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class QuinticSpline {
public:
    static constexpr std::string_view name = "quintic_spline";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit QuinticSpline(double support)
        : h_{name, support},
          inner_{coefficients({26, 50, 20, -20, -20, 10})},
          middle_{coefficients({1, 5, 10, 10, 5, -5})},
          c0_{h_.factor(243 * sigma(), Dim, 5)},
          c1_{h_.factor(-15 * sigma(), Dim, 4, 1)},
          c2_{h_.factor(180 * sigma(), Dim, 3, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r);
        if (3.0 * x < h) return polynomial(inner_, std::fma(-3.0, x, h));
        if (3.0 * x < 2.0 * h) return polynomial(middle_, std::fma(-3.0, x, 2.0 * h));
        const double t = h - x, t2 = t * t;
        return c0_ * (t2 * t2 * t);  // (3 − s)⁵ = 243 (1 − q)⁵
    }
    double derivative(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r), s = 3.0 * x;
        if (s < h) return c1_ * 2.0 * s * (12.0 * h * (h * h - s * s) + 5.0 * s * s * s);
        const double m = 2.0 * h - s, h2 = h * h;
        if (m > 0.0)
            return c1_ * (h2 * h2 + m * (4.0 * h2 * h + m * (6.0 * h2 + m * (4.0 * h - 5.0 * m))));
        const double t = 3.0 * (h - x);
        return c1_ * (t * t) * (t * t);
    }
    double second_derivative(double r) const {
        const double h = h_.scaled(), x = h_.clamp(r), s = 3.0 * x;
        if (s < h) return -2.0 * c2_ * (h * (3.0 * h * h - 9.0 * s * s) + 5.0 * s * s * s);
        const double m = 2.0 * h - s;
        if (m > 0.0) return c2_ * (h * h * h + m * (3.0 * h * h + m * (3.0 * h - 5.0 * m)));
        const double t = 3.0 * (h - x);
        return c2_ * (t * t * t);
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 1 / 40.0L : Dim == 2 ? 63 / (478 * pi) : 9 / (40 * pi);
    }
    /// σ / h^Dim times the given numbers, for m in scaled lengths.
    std::array<double, 6> coefficients(const std::array<int, 6>& a) const {
        std::array<double, 6> scaled;
        for (int k = 0; k < 6; ++k) scaled[k] = h_.factor(a[k] * sigma(), Dim, k);
        return scaled;
    }

    Support h_;
    std::array<double, 6> inner_, middle_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
