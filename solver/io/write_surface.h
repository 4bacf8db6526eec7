#pragma once

#include "solver/io/poly_data.h"
#include "solver/surface/isosurface.h"

namespace plumbline {

/// Each writes vertices and facets with 17 digits, so that reading gives the same bits: Wavefront OBJ, with
/// normals; PLY (text), with normals; VTP for ParaView, with an array "normals". In the plane facets are
/// edges, and z is 0.
template <int Dim> void write_surface_obj(std::ostream& out, const Isosurface<Dim>& surface);
template <int Dim> void write_surface_ply(std::ostream& out, const Isosurface<Dim>& surface);
template <int Dim> PolyData poly_data_of(const Isosurface<Dim>& surface);

}  // namespace plumbline
