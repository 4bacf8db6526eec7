#pragma once

#include "solver/kernels/kernel.h"

#include <Eigen/LU>

#include <cmath>

namespace plumbline {

/// ‖G⁻¹‖₂ in 1D, 2D and 3D: how far the unit ball reaches when G maps onto it.
template <int Dim> double norm_of_inverse(const Mat<Dim>& g);

/// ω(x) = |det G| ω₀(‖G x‖): a radial kernel ω₀ seen through the linear map G, an ellipsoid instead of a
/// ball; the determinant keeps ∫ ω dV = 1. adams2009 Sec. 2.1 allows it; the form is Owen et al. 1998.
/// Not radial, so value, gradient, Hessian and Laplacian take the vector x [m].
template <RadialKernel K> class Anisotropic {
public:
    static constexpr int dim = K::dim;

    /// `g`: dimensionless, finite and invertible, or InvalidInput is thrown.
    Anisotropic(const K& w, const Mat<dim>& g) : g_{g}, det_{std::abs(g.determinant())}, w_{w} {
        if (!g.allFinite() || !(det_ > 0.0))
            throw InvalidInput("Anisotropic: expected a finite, invertible matrix G");
        support_ = w.support() * norm_of_inverse<dim>(g);
    }

    /// Radius of the smallest ball that holds the ellipsoid {x : ‖G x‖ < support of ω₀} [m].
    double support() const { return support_; }

    double value(const Vec<dim>& x) const { return det_ * w_.value((g_ * x).norm()); }

    /// |det G| Gᵀ (∇ω₀)(G x)
    Vec<dim> gradient(const Vec<dim>& x) const {
        return det_ * (g_.transpose() * plumbline::gradient(w_, Vec<dim>(g_ * x)));
    }
    /// |det G| Gᵀ (∇∇ω₀)(G x) G
    Mat<dim> hessian(const Vec<dim>& x) const {
        return det_ * (g_.transpose() * plumbline::hessian(w_, Vec<dim>(g_ * x)) * g_);
    }
    double laplacian(const Vec<dim>& x) const { return hessian(x).trace(); }

private:
    Mat<dim> g_;
    double det_, support_;
    K w_;
};

}  // namespace plumbline
