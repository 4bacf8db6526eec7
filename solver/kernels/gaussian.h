#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <cmath>
#include <numbers>

namespace plumbline {

/// ω(r) = σ exp(−9 q²) with q = r / h, cut off at h, which is 3 length scales of the Gaussian, and normalised
/// over its support. At the rim ω falls from e⁻⁹ ω(0) ≈ 1.2e-4 ω(0) to 0 in a jump, and ω′ from
/// −18 e⁻⁹ ω(0) / h; ∇ω and Δω are those of the inside.
/// Gingold & Monaghan 1977, named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class Gaussian {
public:
    static constexpr std::string_view name = "gaussian";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Gaussian(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 0)},
          c1_{h_.factor(-18 * sigma(), Dim, 1, 1)},
          c2_{h_.factor(18 * sigma(), Dim, 2, 2)} {
        const long double k = 9 / (static_cast<long double>(h_.scaled()) * h_.scaled());
        nine_over_h2_.value = static_cast<double>(k);
        nine_over_h2_.rest = static_cast<double>(k - nine_over_h2_.value);
    }

    double support() const { return h_.radius(); }

    double value(double r) const { return c0_ * bell(r); }
    double derivative(double r) const { return c1_ * h_.clamp(r) * bell(r); }  // −18 σ q exp(−9 q²)
    double second_derivative(double r) const {  // 18 σ (18 q² − 1) exp(−9 q²)
        const double h = h_.scaled(), x = h_.clamp(r);
        return c2_ * (18.0 * x * x - h * h) * bell(r);
    }

private:
    /// exp(−9 q²) inside, 0 outside. The rest of the exponent counts: exp turns its absolute error
    /// into a relative one.
    double bell(double r) const {
        if (r >= h_.radius()) return 0.0;
        const Twofold exponent = square(h_.clamp(r)) * nine_over_h2_;
        const double e = std::exp(-exponent.value);
        return std::fma(-exponent.rest, e, e);
    }
    static long double sigma() {
        constexpr long double root_pi = 1 / std::numbers::inv_sqrtpi_v<long double>;
        const long double inside = std::erf(3.0L), rim = std::exp(-9.0L);
        if (Dim == 1) return 3 / (root_pi * inside);
        if (Dim == 2) return 9 / (root_pi * root_pi * (1 - rim));
        return 27 / (root_pi * root_pi * (root_pi * inside - 6 * rim));
    }

    Support h_;
    Twofold nine_over_h2_{};
    double c0_, c1_, c2_;
};

}  // namespace plumbline
