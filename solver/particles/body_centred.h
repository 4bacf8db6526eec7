#pragma once

#include "solver/particles/lattice.h"

namespace plumbline {

/// The body centred cubic lattice (D/√3)(l, m, n), l, m, n all even or all odd, with D = `spacing`
/// [m]: volume 4 D³/(3√3) per point; shells of 8, 6, 12, 24 neighbours at D √(3, 4, 8, 11)/√3.
/// Periodic in a box whose edges are multiples of 2D/√3.
/// Throws as cell_centres does; a cell is a cube of D/√3, and every fourth one holds a point.
inline Points<3> body_centred(const Box<3>& box, double spacing) {
    return cell_centres<3>(box, Vec<3>::Constant(spacing / std::sqrt(3.0)), [](const auto& k) {
        return k[0] % 2 == k[1] % 2 && k[1] % 2 == k[2] % 2;
    });
}

}  // namespace plumbline
