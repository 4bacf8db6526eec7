#pragma once

#include "solver/scene/simulation.h"

#include <string>

namespace reports {

/// The surface of the fluid as the scene asks for it, as the text of a file in its format.
std::string surface_text(const plumbline::SceneFile& scene, const plumbline::Snapshot& particles);

}  // namespace reports
