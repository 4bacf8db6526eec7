#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

/// A cell of a cubic grid with 2^bits cells along each axis.
template <int Dim> using GridCell = std::array<std::uint32_t, Dim>;

/// So many bits per axis that a cell's place on a curve through all cells fits into 64 bits.
template <int Dim> constexpr int curve_bits = Dim == 1 ? 32 : Dim == 2 ? 31 : 21;

/// The cells of `points` in the smallest cubic grid of 2^curve_bits cells per axis that holds them.
/// Throws InvalidInput for a coordinate that is not finite.
template <int Dim> std::vector<GridCell<Dim>> grid_cells(std::span<const Vec<Dim>> points) {
    if (points.empty()) return {};
    Vec<Dim> low = points.front(), high = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite())
            throw InvalidInput("space-filling order: expected finite coordinates, found point " +
                               std::to_string(i) + " without");
        low = low.cwiseMin(points[i]);
        high = high.cwiseMax(points[i]);
    }
    const double cells = std::ldexp(1.0, curve_bits<Dim>);
    const double extent = (high - low).maxCoeff();
    std::vector<GridCell<Dim>> found(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t d = 0; d < Dim; ++d) {
            const double share = extent > 0.0 ? (points[i][d] - low[d]) / extent : 0.0;
            found[i][d] = static_cast<std::uint32_t>(std::min(share * cells, cells - 1.0));
        }
    return found;
}

/// The points in the order in which a curve visits their cells: the k-th is points[order[k]].
/// Points of one cell keep their order. `place` maps a cell to its place on the curve.
template <int Dim, class Place>
std::vector<Index> order_along(std::span<const Vec<Dim>> points, Place place) {
    const auto cells = grid_cells<Dim>(points);
    std::vector<std::pair<std::uint64_t, Index>> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        keys[i] = {place(cells[i]), static_cast<Index>(i)};
    std::ranges::sort(keys);
    std::vector<Index> order(points.size());
    std::ranges::transform(keys, order.begin(), [](const auto& key) { return key.second; });
    return order;
}

}  // namespace plumbline
