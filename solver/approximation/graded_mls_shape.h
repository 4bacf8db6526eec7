#pragma once

#include "solver/approximation/mls_shape.h"
#include "solver/particles/box.h"

#include <algorithm>
#include <string>

namespace plumbline {

/// MlsShape where every sample has a support of its own, hⱼ [m], as samples of varying density need:
///     ωⱼ(x) = ω(s ‖x − xⱼ‖ / hⱼ) with s = w.support(),
/// hence ∇ωⱼ and Δωⱼ carry the factors s/hⱼ and (s/hⱼ)². The basis is scaled by the largest hⱼ of the
/// neighbours. As exact as MlsShape, since that asks nothing of the weights (adams2009 Sec. 3.1).
template <int Order, RadialKernel K> class GradedMlsShape {
public:
    static constexpr int dim = K::dim;

    /// `supports`: one per sample; a view. Throws InvalidInput unless all are finite and positive.
    GradedMlsShape(K w, std::span<const double> supports) : w_{w}, supports_{supports} {
        for (const double h : supports) require_positive(h, "support of a sample");
    }

    /// As MlsShape; `at` lists the samples with ‖x − xⱼ‖ < hⱼ, and may list others, which have no weight.
    /// Throws InvalidInput unless there is one support per sample.
    std::optional<Fit> operator()(std::span<const Vec<dim>> x, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        if (x.size() != supports_.size())
            throw InvalidInput("GradedMlsShape: expected one support for each of " +
                               std::to_string(x.size()) + " samples, found " +
                               std::to_string(supports_.size()));
        double largest = 0.0;
        for (std::size_t k = 0; k < at.neighbours.size(); ++k) {
            const Index j = at.neighbours[k];
            const double scale = w_.support() / supports_[j];
            const Vec<dim> d = scale * (at.x - x[j]);
            row.phi[k] = w_.value(d.norm());
            if (!row.grad_phi.empty()) row.grad_phi[k] = scale * gradient(w_, d);
            if (!row.laplace_phi.empty())
                row.laplace_phi[k] = scale * scale * laplacian(w_, d.norm());
            largest = std::max(largest, supports_[j]);
        }
        return mls_from_weights<dim, Order>(x, at, largest, row);
    }

private:
    K w_;
    std::span<const double> supports_;
};

}  // namespace plumbline
