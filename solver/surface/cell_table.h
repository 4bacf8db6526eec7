#pragma once

#include <array>
#include <cstdint>

namespace plumbline {

/// How the surface runs through one cell of a grid: the facets are edges in a square, triangles in a
/// cube, and each of their corners lies on an edge of the cell.
///
/// Corner c of the cell is on the high side of axis d iff bit d of c is set; the edge from a corner c on
/// the low side of axis d along that axis has the number Dim c + d.
template <int Dim> struct CellCase {
    static constexpr int most = Dim == 2 ? 2 : 5;
    int count = 0;
    std::array<std::array<std::uint8_t, Dim>, most> facets{};
};

/// One case for each set of corners that are inside: bit c of its number is set iff corner c is.
template <int Dim> using CellTable = std::array<CellCase<Dim>, (1 << (1 << Dim))>;

/// The tables of marching squares and marching cubes (Lorensen and Cline 1987), not typed in but made
/// by a rule, so that neighbouring cells fit together:
/// - on a face of the cell each run of inside corners is cut off by one segment, so that two inside corners
///   at opposite ends of a diagonal are never joined, whichever cell looks at the face;
/// - the segments of all faces form closed loops around the cell;
/// - a loop is triangulated without a diagonal that lies in a face, since the cell behind that face
///   might have the same one.
/// Hence the surface of any field is closed, with two facets at every edge, and facets face outwards.
template <int Dim> const CellTable<Dim>& cell_table();

}  // namespace plumbline
