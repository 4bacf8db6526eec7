#pragma once

#include "solver/scene/simulation.h"

namespace plumbline {

/// Sums and extremes over all particles. In the plane vectors have z = 0, and angular momentum only z.
struct Scalars {
    double kinetic = 0.0;                      // Σ m v²/2 [J]
    double potential = 0.0;                    // −Σ m g·x [J]
    double internal = 0.0;                     // Σ m e(ρ) of the Tait equation, 0 without one [J]
    Vec<3> momentum = Vec<3>::Zero();          // [kg m/s]
    Vec<3> angular_momentum = Vec<3>::Zero();  // about the origin [kg m²/s]
    Vec<3> centre = Vec<3>::Zero();            // of mass [m]
    double front = 0.0;                        // the largest x [m]
    double height = 0.0;         // the highest particle, against gravity, or the last axis [m]
    double largest_speed = 0.0;  // [m/s]
};

/// All sums in the order of the particles, so that they do not depend on the number of threads.
Scalars scalars_of(const SceneFile& scene, const Snapshot& particles);

/// What the probe shows. Pressure, density and speed: Σ V f ω / Σ V ω over the particles around (Shepard), 0 where there
/// are none, as in air. Height: of the highest particle nearer than half a support to the vertical through the
/// probe, against gravity; NaN if there is none.
double reading(const Probe& probe, const SceneFile& scene, const Snapshot& particles);

}  // namespace plumbline
