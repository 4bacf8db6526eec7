#pragma once

#include "benchmarks/approximation/frontier_methods.h"
#include "solver/approximation/shape_functions.h"

#include <memory>

namespace benchmarks {

inline plumbline::Derivatives derivatives_for(verification::Quantity quantity) {
    return static_cast<plumbline::Derivatives>(quantity);
}

/// Storage for the shape functions of one place at a time.
struct RowBuffer {
    std::vector<double> phi, laplace_phi;
    std::vector<plumbline::Vec<2>> grad_phi;

    plumbline::ShapeRow<2> row(std::size_t n, plumbline::Derivatives wanted) {
        const bool first = wanted >= plumbline::Derivatives::gradient;
        const bool second = wanted >= plumbline::Derivatives::laplacian;
        phi.resize(n);
        grad_phi.resize(first ? n : 0);
        laplace_phi.resize(second ? n : 0);
        return {phi, grad_phi, laplace_phi};
    }
};

/// Σⱼ Φⱼ fⱼ, Σⱼ ∇Φⱼ fⱼ or Σⱼ ΔΦⱼ fⱼ.
inline void write_sum(const plumbline::ShapeRow<2>& row, std::span<const plumbline::Index> js,
                      std::span<const double> f, verification::Quantity quantity, double* to) {
    using verification::Quantity;
    if (quantity == Quantity::gradient) {
        plumbline::Vec<2> sum = plumbline::Vec<2>::Zero();
        for (std::size_t k = 0; k < js.size(); ++k) sum += row.grad_phi[k] * f[js[k]];
        write(sum, to);
        return;
    }
    const auto weights = quantity == Quantity::value ? row.phi : row.laplace_phi;
    double sum = 0;
    for (std::size_t k = 0; k < js.size(); ++k) sum += weights[k] * f[js[k]];
    write(sum, to);
}

/// Lagrangian use of `shape`: computed once for all places, then applied.
template <class Shape>
void add_shape_functions(PreparedMethod& method, const Shape& shape, const Situation& s,
                         verification::Quantity quantity) {
    using plumbline::Index, verification::Quantity;
    const auto stored = std::make_shared<plumbline::ShapeFunctions<2>>();
    const auto width = static_cast<std::size_t>(components_of(quantity));
    method.precompute = [stored, shape, &s, quantity] {
        *stored = plumbline::precompute(shape, std::span<const plumbline::Vec<2>>(s.x),
                                        std::span<const plumbline::Vec<2>>(s.places), s.rows,
                                        derivatives_for(quantity));
    };
    method.apply = [stored, &s, quantity, width](std::span<double> out) {
        for (Index k = 0; k < stored->size(); ++k) {
            double* to = &out[k * width];
            switch (quantity) {
                case Quantity::value:
                    write(stored->value(s.f, k), to);
                    break;
                case Quantity::gradient:
                    write(stored->gradient(s.f, k), to);
                    break;
                case Quantity::laplacian:
                    write(stored->laplacian(s.f, k), to);
                    break;
            }
        }
    };
}

}  // namespace benchmarks
