#pragma once

#include "solver/approximation/shape_row.h"
#include "solver/approximation/sph_shape_function.h"

#include <optional>

namespace plumbline {

/// SPH in the form that every method shares: Φⱼ(x) = Vⱼ ω(‖x − xⱼ‖), so that Σⱼ Φⱼ fⱼ is Eq. 3, Σⱼ ∇Φⱼ fⱼ
/// is Eq. 9 and Σⱼ ΔΦⱼ fⱼ is Eq. 11 with the true Laplacian.                adams2009 Eqs. 39, 40
/// A view of the samples. Exact for no polynomial.
template <RadialKernel K> class SphShape {
public:
    static constexpr int dim = K::dim;

    SphShape(K w, const Samples<dim>& samples) : w_{w}, samples_{samples} {}

    /// As MlsShape; its basis is empty. Empty where `at` has no neighbour.
    std::optional<Fit> operator()(std::span<const Vec<dim>>, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        if (at.neighbours.empty()) return std::nullopt;
        for (std::size_t k = 0; k < at.neighbours.size(); ++k) {
            const Index j = at.neighbours[k];
            row.phi[k] = sph_shape_function(w_, samples_, j, at.x);
            if (!row.grad_phi.empty()) row.grad_phi[k] = sph_shape_gradient(w_, samples_, j, at.x);
            if (!row.laplace_phi.empty())
                row.laplace_phi[k] = sph_shape_laplacian(w_, samples_, j, at.x);
        }
        return Fit{.order = -1, .rank = 0, .size = 0, .condition = 1.0};
    }

private:
    K w_;
    Samples<dim> samples_;
};

}  // namespace plumbline
