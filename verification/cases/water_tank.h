#pragma once

#include "solver/fluid/extrapolated_walls.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"

#include <functional>

namespace verification {

/// Water in the left corner of an open tank in the plane, y up, that stands or sways along x: weakly compressible with
/// density diffusion, sums in single precision, between walls of three layers with the pressure of the fluid.
struct WaterTank {
    plumbline::Vec<2> tank, water;  // edges [m]
    double spacing;          // [m], nearly: edges of tank and water are whole numbers of cells
    double support = 4.0;    // in spacings; with 2.6 a lattice under pressure resists shear
    double alpha = 0.02;     // artificial viscosity
    double diffusion = 0.1;  // of the density
    double courant = 0.2;    // Δt over h/(c + v), h the support; 0.3 is too much for the diffusion
    double sound = 20.0;     // c₀ over √(g H)
    double gravity = 9.81, rest_density = 997.0;
    double sway = 0.0, period = 1.0;  // the tank is at sway · cos(2π t/period) [m, s]
    double jitter = 0.1;  // in spacings, of the particles of the water: it has no lattice
    std::uint64_t seed = 1;
    std::function<plumbline::Vec<2>(const plumbline::Vec<2>&)> velocity = {};  // at the start

    double speed_of_sound() const { return sound * std::sqrt(gravity * water.y()); }
    plumbline::WendlandC2<2> kernel() const { return plumbline::WendlandC2<2>(support * spacing); }
};

/// What an observer sees; walls are among the particles.
struct WaterTankState {
    double time;
    const plumbline::Positions<2>& x;
    const plumbline::Velocities<2>& v;
    const plumbline::Masses& m;
    const plumbline::Density& rho;
    const plumbline::Pressure& p;
    const plumbline::IsWall& wall;
    const plumbline::WallForces<2>& force;
    const plumbline::Vec<2>& gravity;  // apparent
};

/// Calls `observe` at the start and after each step, the last of which ends at `duration` [s].
void simulate(const WaterTank& tank, double duration,
              const std::function<void(const WaterTankState&)>& observe);

/// Of the water alone.
double largest_x(const WaterTankState& state);

/// How high the water stands between two verticals [m]: its volume there over the width. Particles count as squares, of the
/// volume that they have at rest.
double height_between(const WaterTankState& state, double rest_density, double left, double right);

}  // namespace verification
