#pragma once

#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/ghost_continuity.h"
#include "solver/fluid/ghost_pressure_force.h"
#include "solver/fluid/ghost_viscosity.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/two_stage.h"

namespace verification {

/// Fluid between y = 0 and y = 1 [m], on a wall of ghosts or between two, without end along x; density
/// 1, γ = 7.
struct Channel {
    double spacing = 0.05;
    double support = 3.0;  // in spacings
    plumbline::Vec<2> gravity = {0.0, 0.0};
    double viscosity = 0.1;     // ν [m²/s]
    bool slip = false;          // ghosts take no part in viscosity
    bool lid = true;            // a second wall, at y = 1
    double speed_of_lid = 0.0;  // along x
    double speed_of_sound = 10.0, diffusion = 0.1, courant = 0.4;
};

/// The fluid at the end.
struct ChannelState {
    plumbline::Points<2> x, v;
    std::vector<double> pressure;
    plumbline::Advance steps;
};

ChannelState simulate(const Channel& channel, double duration);

/// The velocities of a standing wave on the fluid, of depth 1 and of the length 2 (k = π), that starts flat.
struct StandingWave {
    double frequency;  // ω = π/(2t), t when the velocities vanish for the first time [1/s]
    double decay;      // −ln of how much of them there is, the other way round, at 2t
};
/// `steepness` is k a, a the height of the wave.
StandingWave standing_wave(Channel channel, double steepness);

}  // namespace verification
