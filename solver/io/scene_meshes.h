#pragma once

#include "solver/scene/scene_file.h"

namespace plumbline {

/// Reads the meshes that the scene names, from files beside its own; all others are left alone.
/// Throws InvalidInput, naming the table of the scene and the file, as read_mesh and ClosedMesh do.
void read_meshes(SceneFile& scene);

}  // namespace plumbline
