#pragma once

#include "solver/particles/morton_order.h"

namespace plumbline {

/// The place of `cell` on the Hilbert curve, by Skilling's transformation of the coordinates into
/// those whose Morton place is the wanted one.
/// Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707 (2004).
template <int Dim> std::uint64_t hilbert_place(GridCell<Dim> cell) {
    constexpr std::uint32_t top = 1u << (curve_bits<Dim> - 1);
    // From the coarsest cubes to the finest: the orientation of the curve inside each is undone.
    for (std::uint32_t bit = top; bit > 1; bit >>= 1) {
        const std::uint32_t below = bit - 1;
        for (std::size_t d = 0; d < Dim; ++d) {
            if (cell[d] & bit) {
                cell[0] ^= below;
            } else {
                const std::uint32_t exchanged = (cell[0] ^ cell[d]) & below;
                cell[0] ^= exchanged;
                cell[d] ^= exchanged;
            }
        }
    }
    // Gray code: the cubes of one level are visited in an order that changes one coordinate at a time.
    for (std::size_t d = 1; d < Dim; ++d) cell[d] ^= cell[d - 1];
    std::uint32_t flips = 0;
    for (std::uint32_t bit = top; bit > 1; bit >>= 1)
        if (cell[Dim - 1] & bit) flips ^= bit - 1;
    for (std::uint32_t& coordinate : cell) coordinate ^= flips;
    return morton_place<Dim>(cell);
}

/// The points sorted along the Hilbert curve, which only ever steps to a cell that shares a face: the
/// order with the best locality. The k-th point is points[order[k]].
/// Throws InvalidInput for a coordinate that is not finite.
template <int Dim> std::vector<Index> hilbert_order(std::span<const Vec<Dim>> points) {
    return order_along<Dim>(points, hilbert_place<Dim>);
}

}  // namespace plumbline
