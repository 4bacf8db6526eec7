#pragma once

#include "solver/particles/space_filling_order.h"

namespace plumbline {

/// The place of `cell` on the Morton curve: the bits of its coordinates interleaved, the most
/// significant first, x before y before z within each group.                          Morton 1966
template <int Dim> std::uint64_t morton_place(const GridCell<Dim>& cell) {
    std::uint64_t place = 0;
    for (int bit = curve_bits<Dim> - 1; bit >= 0; --bit)
        for (std::size_t d = 0; d < Dim; ++d) place = place << 1 | (cell[d] >> bit & 1u);
    return place;
}

/// The points sorted along the Morton curve: those of a cube of the octree follow one another, but
/// the step from one cube to the next may be long. The k-th point is points[order[k]].
/// Throws InvalidInput for a coordinate that is not finite.
template <int Dim> std::vector<Index> morton_order(std::span<const Vec<Dim>> points) {
    return order_along<Dim>(points, morton_place<Dim>);
}

}  // namespace plumbline
