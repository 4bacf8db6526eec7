#pragma once

#include "solver/surface/cell_table.h"
#include "solver/surface/scalar_grid.h"

namespace plumbline {

/// The border of a region: edges in the plane, with the inside on their left; triangles in space,
/// counter-clockwise seen from outside.
template <int Dim> struct Isosurface {
    Points<Dim> vertices;  // [m]
    Points<Dim> normals;   // of length 1, outwards; 0 where the field has no slope
    std::vector<std::array<Index, Dim>> facets;  // Dim vertices each
};

/// Where the field is `level`; inside is where it is smaller.   Lorensen and Cline 1987, marching cubes
/// Fields are linear along edges of the grid, normals are central differences, so both are of order 2 in
/// the spacing. The surface is closed, but for where it leaves the grid, and no edge has more than two
/// facets, for any field: see cell_table. Where a node has the level itself, facets may have no area.
/// Values that are not finite are outside; their neighbours inside then lie half a spacing from the surface.
/// Throws InvalidInput unless there is one value for each node, and two nodes along each axis.
template <int Dim>
Isosurface<Dim> isosurface(const ScalarGrid<Dim>& field, double level,
                           const CellTable<Dim>& table = cell_table<Dim>());

/// The volume [m³] (area [m²]) that a closed surface holds: Σ ⟨a, n A⟩ / Dim over its facets.
template <int Dim> double volume(const Isosurface<Dim>& surface);
/// The area [m²] (length [m]) of the facets.
template <int Dim> double area(const Isosurface<Dim>& surface);

}  // namespace plumbline
