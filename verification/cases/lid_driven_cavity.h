#pragma once

#include "solver/foundation/types.h"

#include <vector>

namespace verification {

/// Fluid in [0, 1]² under a lid that moves along x at 1 m/s, sticking to all walls; density 1.
struct LidDrivenCavity {
    double reynolds = 100.0;
    double spacing = 1.0 / 20.0;
    double support = 4.0;  // in spacings; as shifting, that of TaylorGreen
    double speed_of_sound = 10.0, diffusion = 0.1, courant = 0.3;
    double shifting = 20.0;   // strength A
    double background = 1.0;  // pressure that the fluid starts with, so that none is negative [Pa]
    bool sticks = true;       // else walls slip, without viscosity, and the lid moves nothing
};

/// The velocities when they are steady, in the mean over the last second: u at (0.5, yₖ), v at (xₖ, 0.5).
struct CavityProfiles {
    std::vector<double> u, v;
    double time;             // when the run ended [s]
    double change_per_time;  // of the kinetic energy, relative, in the last second
};
/// Runs until the kinetic energy has changed by less than 0.2 % per second three times in a row, but until `latest` [s] at
/// the most.
CavityProfiles profiles_of(const LidDrivenCavity& cavity, const std::vector<double>& y,
                           const std::vector<double>& x, double latest);

}  // namespace verification
