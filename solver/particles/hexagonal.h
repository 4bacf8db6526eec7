#pragma once

#include "solver/particles/lattice.h"

namespace plumbline {

/// The hexagonal lattice i (D, 0) + j (D/2, √3 D/2) with D = `spacing` [m], the densest in the
/// plane: area √3 D²/2 per point; shells of 6, 6, 6, 12, 6 neighbours at D √(1, 3, 4, 7, 9).
/// Periodic in a box whose edges are multiples of D and of √3 D. wicke2006 Eq. 1, in the plane.
/// Throws as cell_centres does; a cell is D/2 × √3 D/2, and every second one holds a point.
inline Points<2> hexagonal(const Box<2>& box, double spacing) {
    return cell_centres<2>(box, {0.5 * spacing, 0.5 * std::sqrt(3.0) * spacing},
                           [](const auto& k) { return (k[0] + k[1]) % 2 == 0; });
}

}  // namespace plumbline
