#pragma once

#include "solver/scene/scene_file.h"
#include "solver/scene/toml_section.h"

namespace plumbline {

/// Refuses a key that means nothing with what else the file says, like an unknown one.
void only_with(TomlSection& section, const std::string& key, bool allowed, const std::string& what);
/// The corners "low" and "high".
void read_box(TomlSection& s, int dim, Vec<3>& low, Vec<3>& high);
/// A vector that is not zero, made as long as 1.
Vec<3> read_direction(TomlSection& s, const std::string& key, int dim);

/// A table [[constraint]].
SolidConstraint read_constraint(TomlSection& s, const SceneFile& scene);
/// A table [[body]].
SceneBody read_body(TomlSection& s, const SceneFile& scene);
/// A table [[emitter]].
SceneEmitter read_emitter(TomlSection& s, const SceneFile& scene);
/// A table [[outflow]].
SolidShape read_outflow(TomlSection& s, const SceneFile& scene);

}  // namespace plumbline
