#pragma once

#include "solver/approximation/mls_shape.h"
#include "solver/approximation/polynomial_basis.h"
#include "verification/framework/mutant.h"

namespace verification {

inline constinit Mutant eq_21_at_the_point{38, "Eqs. 21, 22, 24 with p(x) for p(xᵢ)",
                                           "MLS shape functions"};
inline constinit Mutant eq_30_with_centred_basis{25, "Eq. 30 with the centred basis of Eq. 29",
                                                 "∇ of MLS shape functions"};

/// The seam of moving least squares.
/// - With p(x) in the place of p(xᵢ), M = Σ ω p(x) p(x)ᵀ has rank 1, and its smallest solution is
///   a = p(x) Σ ωⱼ fⱼ / (p(x)ᵀ p(x) Σ ωⱼ): ⟨f⟩ = p(x)ᵀ a is the approximation of order 0.
/// - With p(0) and p(yᵢ) constant, what Eq. 30 loses is the part in which only p is differentiated:
///   the diffuse derivative.
template <int Order, plumbline::RadialKernel K> class MlsUnderTest {
public:
    static constexpr int dim = K::dim;
    using Derivative = plumbline::MlsDerivative;

    explicit MlsUnderTest(K w, Derivative derivative = Derivative::full)
        : w_{w}, derivative_{derivative} {}

    std::optional<plumbline::Fit> operator()(std::span<const plumbline::Vec<dim>> x,
                                             const plumbline::Place<dim>& at,
                                             plumbline::ShapeRow<dim> row) const {
        const auto fit = with_basis_at_samples<Order>(x, at, row);
        if (Order > 0 && !row.grad_phi.empty() && eq_30_with_centred_basis.applied())
            subtract_diffuse_gradient(x, at, row);
        if (Order == 0 || !fit || !eq_21_at_the_point.applied()) return fit;
        const auto constant = with_basis_at_samples<0>(x, at, row);
        return plumbline::Fit{Order, 1, fit->size, constant->condition};
    }

private:
    template <int N>
    std::optional<plumbline::Fit> with_basis_at_samples(std::span<const plumbline::Vec<dim>> x,
                                                        const plumbline::Place<dim>& at,
                                                        plumbline::ShapeRow<dim> row) const {
        return plumbline::MlsShape<N, K>(w_, derivative_)(x, at, row);
    }
    void subtract_diffuse_gradient(std::span<const plumbline::Vec<dim>> x,
                                   const plumbline::Place<dim>& at,
                                   plumbline::ShapeRow<dim> row) const {
        std::vector<double> phi(row.phi.size());
        std::vector<plumbline::Vec<dim>> grad_phi(row.phi.size());
        plumbline::MlsShape<Order, K>(w_, Derivative::diffuse)(x, at, {phi, grad_phi, {}});
        for (std::size_t j = 0; j < phi.size(); ++j) row.grad_phi[j] -= grad_phi[j];
    }

    K w_;
    Derivative derivative_;
};

}  // namespace verification
