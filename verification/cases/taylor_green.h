#pragma once

#include "solver/fluid/averaged_pressure_force.h"
#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/particle_shifting.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/two_stage.h"

#include <numbers>

namespace verification {

/// Vortices that decay in a box without end, [0, 1]²: u = −e^(−8π² t/Re) cos 2πx sin 2πy, v alike.
struct TaylorGreen {
    double reynolds = 100.0;
    double spacing = 1.0 / 20.0;
    double shifting = 20.0;       // strength A
    double support = 4.0;         // in spacings
    double speed_of_sound = 7.0;  // in units of the largest speed: densities differ by 1 %
    double diffusion = 0.1;       // δ
    double courant = 0.3;         // Δt over h/(c + v); near 0.4 the midpoint rule feeds sound
};

inline plumbline::Vec<2> taylor_green_velocity(const plumbline::Vec<2>& x, double decay) {
    const double k = 2.0 * std::numbers::pi;
    return {-decay * std::cos(k * x[0]) * std::sin(k * x[1]),
            decay * std::sin(k * x[0]) * std::cos(k * x[1])};
}

struct TaylorGreenErrors {
    double velocity;  // mean ‖v − exact‖ at the end, over the largest exact speed
    double energy;    // kinetic energy over the exact one, less 1
    plumbline::Advance steps;
};

/// The errors of fluid on [0, 1]², of mass 1 in all, after `duration`.
template <class Scene>
TaylorGreenErrors errors_of(const Scene& scene, const TaylorGreen& c, double duration) {
    using namespace plumbline;
    const double k = 2.0 * std::numbers::pi;
    const double decay = std::exp(-2.0 * k * k / c.reynolds * duration);
    const auto& x = scene.template get<Positions<2>>();
    const auto& v = scene.template get<Velocities<2>>();
    TaylorGreenErrors errors{0.0, 0.0, {}};
    const double mass = 1.0 / static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        errors.velocity += mass * (v[i] - taylor_green_velocity(x[i], decay)).norm() / decay;
        errors.energy += mass * v[i].squaredNorm();
    }
    errors.energy = errors.energy / (0.5 * decay * decay) - 1.0;
    return errors;
}

template <template <int> class Family = plumbline::WendlandC2>
TaylorGreenErrors simulate(const TaylorGreen& c, double duration) {
    using namespace plumbline;
    using Box = PeriodicBox<2>;
    using Search = CellGrid<2, Box>;
    using W = Family<2>;
    const Box box(Vec<2>::Zero(), Vec<2>::Ones());
    const double h = c.support * c.spacing, nu = 1.0 / c.reynolds;
    const W w(h);
    const auto points = lattice<2>({box.low(), box.high()}, c.spacing);
    const double mass = 1.0 / static_cast<double>(points.size());
    const TaitEquation tait(1.0, c.speed_of_sound, 7.0);
    Scene scene{
        Given<Positions<2>, Velocities<2>, Masses, Density>{},
        WrapIntoBox<2>{box},
        TwoStage{Evolve<2, Density>{}, WrapIntoBox<2>{box},
                 FindNeighbours<2, Search>{h, Search(box)}, Continuity<W, Box>{w},
                 DensityDiffusion<W, Box>{w, c.diffusion, c.speed_of_sound}, TaitPressure{tait},
                 AveragedPressureForce<W, Box>{w}, BrookshawViscosity<W, Box>{w, nu}},
        AcousticLimit<2>{tait, h, c.courant},
        ViscousLimit{nu, h},
        ShiftParticles<W, Box>{w, c.shifting}};
    scene.template get<Positions<2>>().assign(points.begin(), points.end());
    for (const Vec<2>& x : points)
        scene.template get<Velocities<2>>().push_back(taylor_green_velocity(x, 1.0));
    scene.template get<Masses>().assign(points.size(), mass);
    scene.template get<Density>().assign(points.size(), 1.0);
    const Advance steps = advance_by_limits(scene, duration);
    TaylorGreenErrors result = errors_of(scene, c, duration);
    result.steps = steps;
    return result;
}

/// The same by DFSPH with the cubic spline, particles moving by at most `courant` spacings per step. Without shifting its
/// pressures only push: vortices, which need a pull, open holes. With shifting they may pull, and nothing but shifting
/// corrects densities.
TaylorGreenErrors simulate_incompressible(const TaylorGreen& c, double duration);

}  // namespace verification
