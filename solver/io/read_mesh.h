#pragma once

#include "solver/particles/closed_mesh.h"

#include <filesystem>

namespace plumbline {

/// Reads a surface from an OBJ, OFF, PLY or STL file, told by its extension; polygons are cut into
/// triangles, and equal vertices (STL repeats them) become one. Whether it is closed is for
/// ClosedMesh to say.
/// Throws InvalidInput for no such file, another extension, a file that CGAL cannot read as what
/// its extension says, and one without triangles.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace plumbline
