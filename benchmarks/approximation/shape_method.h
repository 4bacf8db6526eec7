#pragma once

#include "benchmarks/approximation/frontier_methods.h"
#include "solver/approximation/shape_functions.h"

#include <functional>

namespace benchmarks {

/// Writes what a method says at place k; returns how many answers are missing. Its type is forgotten
/// place by place, so that a kernel costs the compiler its inner loop alone.
using Answer = std::function<std::size_t(plumbline::Index k, double* to)>;

template <class Op> Answer answer_of(Op op) {
    return [op](plumbline::Index k, double* to) { return write(op(k), to); };
}

/// A ShapeMethod of any type, likewise.
template <int Dim> struct AnyShape {
    static constexpr int dim = Dim;
    std::function<std::optional<plumbline::Fit>(std::span<const plumbline::Vec<Dim>>,
                                                const plumbline::Place<Dim>&,
                                                plumbline::ShapeRow<Dim>)>
        shape;

    std::optional<plumbline::Fit> operator()(std::span<const plumbline::Vec<Dim>> x,
                                             const plumbline::Place<Dim>& at,
                                             plumbline::ShapeRow<Dim> row) const {
        return shape(x, at, row);
    }
};

/// A method given by what it says at each place.
template <int Dim>
PreparedMethod at_places(std::string name, bool reads_volumes, const Situation<Dim>& s,
                         verification::Quantity quantity, Answer answer);

/// Lagrangian use of `shape`: computed once for all places, then applied.
template <int Dim>
void add_shape_functions(PreparedMethod& method, AnyShape<Dim> shape, const Situation<Dim>& s,
                         verification::Quantity quantity);

/// A method given by its shape functions, in Eulerian and Lagrangian use. `falls_back`: a lower rank is
/// what the method is for, and no failure.
template <int Dim>
PreparedMethod by_shape_functions(std::string name, AnyShape<Dim> shape, bool falls_back,
                                  const Situation<Dim>& s, verification::Quantity quantity);

template <int Dim> plumbline::Place<Dim> place(const Situation<Dim>& s, plumbline::Index k) {
    return {s.places[k], s.rows.of(k)};
}

}  // namespace benchmarks
