#pragma once

#include "solver/foundation/twofold.h"
#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// ω(r) = σ (1 + 3 q)(1 − q)³ with q = r / h; twice continuously differentiable, flat at the centre.
/// Lucy 1977; named in adams2009 Sec. 2.1.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class Lucy {
public:
    static constexpr std::string_view name = "lucy";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Lucy(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 4)},
          c1_{h_.factor(-12 * sigma(), Dim, 3, 1)},
          c2_{h_.factor(12 * sigma(), Dim, 2, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {  // σ (1 + 3 q)(1 − q)³
        const double h = h_.scaled(), x = h_.clamp(r);
        const Twofold t = difference(h, x);
        return c0_ * rounded_product(t * t, t) * std::fma(3.0, x, h);
    }
    double derivative(double r) const {  // −12 σ q (1 − q)²
        const double x = h_.clamp(r), t = h_.scaled() - x;
        return c1_ * x * (t * t);
    }
    double second_derivative(double r) const {  // 12 σ (1 − q)(3 q − 1)
        const double h = h_.scaled(), x = h_.clamp(r);
        return c2_ * (h - x) * (3.0 * x - h);
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 5 / 4.0L : Dim == 2 ? 5 / pi : 105 / (16 * pi);
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
