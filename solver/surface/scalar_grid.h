#pragma once

#include "solver/particles/box.h"

#include <array>
#include <span>

namespace plumbline {

/// A field at the nodes of a square (cubic) grid, x varies fastest.
template <int Dim> struct ScalarGrid {
    Vec<Dim> origin;                    // the first node [m]
    double spacing;                     // [m]
    std::array<std::size_t, Dim> size;  // nodes per axis
    std::vector<double> values = {};    // one per node

    std::size_t nodes() const {
        std::size_t n = 1;
        for (const std::size_t along : size) n *= along;
        return n;
    }
    /// From a node to the next one along `axis`, as a difference of their numbers.
    std::size_t stride(int axis) const {
        std::size_t n = 1;
        for (int d = 0; d < axis; ++d) n *= size[d];
        return n;
    }
    std::array<std::size_t, Dim> place(std::size_t node) const {
        std::array<std::size_t, Dim> k;
        for (int d = 0; d < Dim; ++d) k[d] = node % size[d], node /= size[d];
        return k;
    }
    Vec<Dim> position(std::size_t node) const {
        const auto k = place(node);
        Vec<Dim> x;
        for (int d = 0; d < Dim; ++d) x[d] = origin[d] + spacing * static_cast<double>(k[d]);
        return x;
    }
};

/// A grid without values whose nodes cover the points and `margin` [m] around them. Its nodes lie at
/// multiples of the spacing, so that a body at rest is always cut in the same way.
/// Throws InvalidInput for no points, for points that are not finite, and for more than 2³² nodes.
template <int Dim>
ScalarGrid<Dim> grid_around(std::span<const Vec<Dim>> points, double margin, double spacing) {
    require_positive(spacing, "spacing of the grid");
    if (points.empty()) throw InvalidInput("grid: expected at least one point, found none");
    Vec<Dim> low = points[0], high = points[0];
    for (const Vec<Dim>& x : points) {
        if (!x.allFinite())
            throw InvalidInput("grid: expected finite points, found one that is not");
        low = low.cwiseMin(x), high = high.cwiseMax(x);
    }
    ScalarGrid<Dim> grid{{}, spacing, {}};
    double nodes = 1.0;
    for (int d = 0; d < Dim; ++d) {
        const double first = std::floor((low[d] - margin) / spacing);
        const double last = std::ceil((high[d] + margin) / spacing);
        grid.origin[d] = first * spacing;
        nodes *= last - first + 1.0;
        if (!(nodes < 0x1p32))
            throw InvalidInput("grid: expected at most 2^32 nodes; the spacing " +
                               std::to_string(spacing) + " is too small for these points");
        grid.size[d] = static_cast<std::size_t>(last - first) + 1;
    }
    return grid;
}

}  // namespace plumbline
