#pragma once

#include "solver/particles/lattice.h"

namespace plumbline {

/// The cubic close packed (face centred cubic) lattice (D/√2)(l, m, n), l + m + n even, with
/// D = `spacing` [m], the densest in space: volume D³/√2 per point; shells of 12, 6, 24, 12, 24, 8
/// neighbours at D √(1, 2, 3, 4, 5, 6). Periodic in a box whose edges are multiples of √2 D.
///                                                                              wicke2006 Eq. 1
/// Throws as cell_centres does; a cell is a cube of D/√2, and every second one holds a point.
inline Points<3> close_packed(const Box<3>& box, double spacing) {
    return cell_centres<3>(box, Vec<3>::Constant(spacing / std::sqrt(2.0)),
                           [](const auto& k) { return (k[0] + k[1] + k[2]) % 2 == 0; });
}

}  // namespace plumbline
