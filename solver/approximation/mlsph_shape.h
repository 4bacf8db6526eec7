#pragma once

#include "solver/approximation/mls_shape.h"
#include "solver/approximation/moment_inverse.h"

namespace plumbline {

/// Variable-rank moving least squares (MLSPH): the shape functions of the highest order ≤ `Order`
/// whose moment matrix the samples determine; order 0 is Shepard's method.   adams2009 Sec. 4 (Dilts)
/// `Fit::order` says which; the result jumps where it changes.
template <int Order, RadialKernel K> class MlsphShape {
public:
    static constexpr int dim = K::dim;

    /// An order counts as determined if its rank is full and its condition ≤ `largest_condition`.
    explicit MlsphShape(K w, double largest_condition = well_conditioned)
        : w_{w}, largest_condition_{largest_condition} {}

    /// As MlsShape. Empty only where no sample has a finite, positive weight.
    std::optional<Fit> operator()(std::span<const Vec<dim>> x, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        const auto fit = MlsShape<Order, K>(w_)(x, at, row);
        if constexpr (Order > 0)
            if (!fit || !fit->complete() || !(fit->condition <= largest_condition_))
                return MlsphShape<Order - 1, K>(w_, largest_condition_)(x, at, row);
        return fit;
    }

private:
    K w_;
    double largest_condition_;
};

}  // namespace plumbline
