#pragma once

#include "benchmarks/approximation/frontier_methods.h"
#include "solver/approximation/shape_functions.h"

#include <memory>

namespace benchmarks {

inline plumbline::Derivatives derivatives_for(verification::Quantity quantity) {
    return static_cast<plumbline::Derivatives>(quantity);
}

/// Storage for the shape functions of one place at a time.
template <int Dim> struct RowBuffer {
    std::vector<double> phi, laplace_phi;
    std::vector<plumbline::Vec<Dim>> grad_phi;

    plumbline::ShapeRow<Dim> row(std::size_t n, plumbline::Derivatives wanted) {
        const bool first = wanted >= plumbline::Derivatives::gradient;
        const bool second = wanted >= plumbline::Derivatives::laplacian;
        phi.resize(n);
        grad_phi.resize(first ? n : 0);
        laplace_phi.resize(second ? n : 0);
        return {phi, grad_phi, laplace_phi};
    }
};

/// Σⱼ Φⱼ fⱼ, Σⱼ ∇Φⱼ fⱼ or Σⱼ ΔΦⱼ fⱼ.
template <int Dim>
void write_sum(const plumbline::ShapeRow<Dim>& row, std::span<const plumbline::Index> js,
               std::span<const double> f, verification::Quantity quantity, double* to) {
    using verification::Quantity;
    if (quantity == Quantity::gradient) {
        plumbline::Vec<Dim> sum = plumbline::Vec<Dim>::Zero();
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
void add_shape_functions(PreparedMethod& method, const Shape& shape, const Situation<Shape::dim>& s,
                         verification::Quantity quantity) {
    using plumbline::Index, verification::Quantity;
    constexpr int Dim = Shape::dim;
    const auto stored = std::make_shared<plumbline::ShapeFunctions<Dim>>();
    const std::size_t width = components_of<Dim>(quantity);
    method.precompute = [stored, shape, &s, quantity] {
        *stored = plumbline::precompute(shape, std::span<const plumbline::Vec<Dim>>(s.x),
                                        std::span<const plumbline::Vec<Dim>>(s.places), s.rows,
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

/// A method given by what it says at place k.
template <int Dim, class Op>
PreparedMethod at_places(std::string name, bool reads_volumes, const Situation<Dim>& s,
                         verification::Quantity quantity, Op op) {
    const std::size_t width = components_of<Dim>(quantity);
    return {std::move(name), reads_volumes, [&s, op, width](std::span<double> out) {
                std::size_t failures = 0;
                for (plumbline::Index k = 0; k < s.places.size(); ++k)
                    failures += write(op(k), &out[k * width]);
                return failures;
            }};
}

/// The same, with the shape functions that give it, to be computed once.
template <int Dim, class Op, class Shape>
PreparedMethod at_places(std::string name, const Situation<Dim>& s, verification::Quantity quantity,
                         Op op, const Shape& shape) {
    PreparedMethod method = at_places(std::move(name), true, s, quantity, op);
    add_shape_functions(method, shape, s, quantity);
    return method;
}

template <int Dim> plumbline::Place<Dim> place(const Situation<Dim>& s, plumbline::Index k) {
    return {s.places[k], s.rows.of(k)};
}

}  // namespace benchmarks
