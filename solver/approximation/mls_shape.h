#pragma once

#include "solver/approximation/samples.h"
#include "solver/approximation/shape_row.h"
#include "solver/kernels/kernel.h"

#include <optional>

namespace plumbline {

/// Turns weights into moving least squares shape functions, in place. `row` holds ωⱼ, ∇ωⱼ and Δωⱼ at
/// the point `at`, of weights of any form and scale, and then Φⱼ, ∇Φⱼ and ΔΦⱼ; `h` [m] scales the
/// basis. Dim 1..3, Order 0..3. Empty, and `row` without meaning, where Σⱼ ωⱼ is not positive or not
/// finite.                                                              adams2009 Eqs. 27–31
template <int Dim, int Order>
std::optional<Fit> mls_from_weights(std::span<const Vec<Dim>> x, const Place<Dim>& at, double h,
                                    ShapeRow<Dim> row);

/// Which derivative of the MLS shape functions: that of Φⱼ itself, or the diffuse one, which treats
/// the weights as constant: as exact on polynomials, cheaper, but not the derivative of ⟨f⟩.
enum class MlsDerivative { full, diffuse };

/// Moving least squares shape functions of consistency order `Order` (0..3) at any point x:
///     Φⱼ(x) = ωⱼ p(0)ᵀ M⁻¹ p(yⱼ),  M = Σⱼ ωⱼ p(yⱼ) p(yⱼ)ᵀ,  yⱼ = (xⱼ − x) / h   adams2009 Eqs. 27–29
/// with ωⱼ = ω(‖x − xⱼ‖) and h = w.support(). Σⱼ Φⱼ(x) q(xⱼ) = q(x) for polynomials q of degree
/// ≤ Order, and so for the derivatives; the Laplacian is consistent from Order 2 on. Does not
/// interpolate: ⟨f⟩(xⱼ) ≠ fⱼ.
template <int Order, RadialKernel K> class MlsShape {
public:
    static constexpr int dim = K::dim;

    explicit MlsShape(K w, MlsDerivative derivative = MlsDerivative::full)
        : w_{w}, derivative_{derivative} {}

    /// Writes the shape functions of the neighbours of `at`, which are indices into the positions `x`
    /// of the samples, into `row`. Samples that do not span the basis lower the rank, not the exactness
    /// on constants. Empty, and `row` without meaning, where no sample has a finite, positive weight.
    std::optional<Fit> operator()(std::span<const Vec<dim>> x, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        const bool moving = derivative_ == MlsDerivative::full;
        for (std::size_t k = 0; k < at.neighbours.size(); ++k) {
            const Vec<dim> d = at.x - x[at.neighbours[k]];
            row.phi[k] = w_.value(d.norm());
            if (!row.grad_phi.empty())
                row.grad_phi[k] = moving ? gradient(w_, d) : Vec<dim>(Vec<dim>::Zero());
            if (!row.laplace_phi.empty())
                row.laplace_phi[k] = moving ? laplacian(w_, d.norm()) : 0.0;
        }
        return mls_from_weights<dim, Order>(x, at, w_.support(), row);
    }

private:
    K w_;
    MlsDerivative derivative_;
};

}  // namespace plumbline
