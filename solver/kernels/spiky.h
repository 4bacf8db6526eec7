#pragma once

#include "solver/kernels/kernel.h"
#include "solver/kernels/support.h"

#include <numbers>

namespace plumbline {

/// ω(r) = σ (1 − q)³ with q = r / h; twice continuously differentiable at the rim. Its slope does not
/// vanish at the centre, so that close particles repel each other; at the kink Δω, which tends to −∞ in
/// 2D and 3D, is taken as 0.
/// adams2009 Eqs. 92–94 (dim 3) and 95–97 (dim 2), there from Müller et al. 2003.
template <int Dim>
requires(1 <= Dim && Dim <= 3) class Spiky {
public:
    static constexpr std::string_view name = "spiky";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless 1e-50 ≤ support ≤ 1e50 [m].
    explicit Spiky(double support)
        : h_{name, support},
          c0_{h_.factor(sigma(), Dim, 3)},
          c1_{h_.factor(-3 * sigma(), Dim, 2, 1)},
          c2_{h_.factor(6 * sigma(), Dim, 1, 2)} {}

    double support() const { return h_.radius(); }

    double value(double r) const {  // σ (1 − q)³, Eqs. 92, 95
        const double t = h_.scaled() - h_.clamp(r);
        return c0_ * (t * t * t);
    }
    double derivative(double r) const {  // −3 σ (1 − q)², Eqs. 93, 96
        const double t = h_.scaled() - h_.clamp(r);
        return c1_ * (t * t);
    }
    double second_derivative(double r) const {  // 6 σ (1 − q), Eqs. 94, 97
        const double t = h_.scaled() - h_.clamp(r);
        return c2_ * t;
    }

private:
    static constexpr long double sigma() {
        constexpr long double pi = std::numbers::pi_v<long double>;
        return Dim == 1 ? 2.0L : Dim == 2 ? 10 / pi : 15 / pi;
    }

    Support h_;
    double c0_, c1_, c2_;
};

}  // namespace plumbline
