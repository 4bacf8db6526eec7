#pragma once

#include "solver/scene/simulation.h"

#include <filesystem>

namespace reports {

/// Draws the particles, coloured by the quantity that the scene asks for, and the walls, as PNG with gnuplot; in
/// space as seen from the side and from above. The colours mean the same in all frames: speeds up to a
/// tenth of that of sound, pressures up to ρ₀ times its square, densities within 1 % of ρ₀.
/// Throws std::runtime_error if gnuplot is missing or fails.
void draw_frame(const std::filesystem::path& png, const plumbline::SceneFile& scene, double time,
                const plumbline::Snapshot& particles);

}  // namespace reports
