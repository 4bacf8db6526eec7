#pragma once

#include "solver/kernels/kernel.h"

#include <numbers>

namespace plumbline {

/// ω(r) = σ (1 − q²)³ with q = r / h; smooth, never negative, flat at the centre.
/// adams2009 Eqs. 86–88 (dim 3) and 89–91 (dim 2); one σ serves ω and both derivatives.
template <int Dim>
requires(Dim == 2 || Dim == 3) class Poly6 {
public:
    static constexpr std::string_view name = "poly6";
    static constexpr int dim = Dim;

    /// Throws InvalidInput unless support > 0 [m].
    explicit Poly6(double support) : h_{support} {
        if (!(support > 0.0)) throw InvalidInput("Poly6: support must be positive");
        constexpr double pi = std::numbers::pi;
        sigma_ = Dim == 2 ? 4.0 / (pi * h_ * h_) : 315.0 / (64.0 * pi * h_ * h_ * h_);
    }

    double support() const { return h_; }

    double value(double r) const {  // Eqs. 86, 89
        const double s = one_minus_q_squared(r);
        return sigma_ * s * s * s;
    }
    double derivative(double r) const {  // Eqs. 87, 90
        const double s = one_minus_q_squared(r);
        return -6.0 * sigma_ / h_ * (r / h_) * s * s;
    }
    double second_derivative(double r) const {  // Eqs. 88, 91
        const double s = one_minus_q_squared(r);
        return 6.0 * sigma_ / (h_ * h_) * s * (4.0 - 5.0 * s);
    }

private:
    double one_minus_q_squared(double r) const { return r < h_ ? 1.0 - (r / h_) * (r / h_) : 0.0; }

    double h_;
    double sigma_;
};

}  // namespace plumbline
