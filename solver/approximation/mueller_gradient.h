#pragma once

#include "solver/approximation/moment_inverse.h"
#include "solver/approximation/samples.h"
#include "solver/approximation/shape_row.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

#include <array>

namespace plumbline {

/// A = Σⱼ ω(‖xᵢⱼ‖) xᵢⱼ xᵢⱼᵀ with xᵢⱼ = xⱼ − xᵢ, inverted; its rank is the number of dimensions that the
/// neighbours span. Empty if there is no neighbour apart from xᵢ.             adams2009 Eq. 38
template <RadialKernel K>
std::optional<MomentInverse<Mat<K::dim>>> mueller_inverse(const K& w,
                                                          std::span<const Vec<K::dim>> x,
                                                          const Place<K::dim>& at) {
    using M = Mat<K::dim>;
    const M A = sum<M>(at.neighbours, [&](Index j) -> M {
        const Vec<K::dim> x_ij = x[j] - at.x;
        return w.value(x_ij.norm()) * x_ij * x_ij.transpose();
    });
    return moment_inverse<K::dim>(A, std::array{K::dim});
}

/// (∇f)(xᵢ) ≈ A⁻¹ Σⱼ ω(‖xᵢⱼ‖) (fⱼ − fᵢ) xᵢⱼ                                adams2009 Eqs. 35–38
/// `f`: n samples of unit U; result [U/m]. Exact for linear f. At samples only: elsewhere there is no
/// fᵢ to start from. Empty if the neighbours do not span the space.
template <RadialKernel K>
std::optional<Vec<K::dim>> mueller_gradient(const K& w, const Samples<K::dim>& s,
                                            std::span<const double> f, Index i) {
    using V = Vec<K::dim>;
    const auto A = mueller_inverse(w, s.x, s.at(i));
    if (!A || A->rank < K::dim) return std::nullopt;
    const V b = sum<V>(s.neighbours.of(i), [&](Index j) -> V {
        const V x_ij = s.x[j] - s.x[i];
        return w.value(x_ij.norm()) * (f[j] - f[i]) * x_ij;
    });
    return V(A->inverse * b);
}

/// The same as shape functions, to be computed once: Φⱼ = δᵢⱼ, ∇Φⱼ = ωⱼ A⁻¹ xᵢⱼ for j ≠ i, and
/// ∇Φᵢ = −Σⱼ ∇Φⱼ. Neighbours that span only a plane or a line give the gradient within it.
template <RadialKernel K> class MuellerShape {
public:
    static constexpr int dim = K::dim;

    explicit MuellerShape(K w) : w_{w} {}

    /// `at` must be a sample (the first one, if several coincide): empty elsewhere, and where it has
    /// no neighbour apart from itself. Throws InvalidInput if a Laplacian is wanted: Eq. 37 has none.
    std::optional<Fit> operator()(std::span<const Vec<dim>> x, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        if (!row.laplace_phi.empty())
            throw InvalidInput("MuellerShape: expected values and gradients, found a Laplacian");
        const auto A = mueller_inverse(w_, x, at);
        std::size_t self = 0;
        while (self < at.neighbours.size() && x[at.neighbours[self]] != at.x) ++self;
        if (!A || self == at.neighbours.size()) return std::nullopt;
        Vec<dim> total = Vec<dim>::Zero();
        for (std::size_t k = 0; k < at.neighbours.size(); ++k) {
            row.phi[k] = k == self ? 1.0 : 0.0;
            if (row.grad_phi.empty()) continue;
            const Vec<dim> x_ij = x[at.neighbours[k]] - at.x;
            row.grad_phi[k] = w_.value(x_ij.norm()) * (A->inverse * x_ij);
            total += row.grad_phi[k];
        }
        if (!row.grad_phi.empty()) row.grad_phi[self] -= total;
        return Fit{.order = 1, .rank = 1 + A->rank, .size = 1 + dim, .condition = A->condition};
    }

private:
    K w_;
};

}  // namespace plumbline
