#pragma once

#include "solver/fluid/dfsph.h"
#include "solver/fluid/ghost_density.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/cubic_spline.h"
#include "solver/scene/composed.h"
#include "solver/scene/scene.h"
#include "solver/scene/terms.h"

namespace plumbline {

namespace detail {
template <class Real, int Dim> inline constexpr bool found_anew<PairGradients<Real, Dim>> = true;
template <class Real, int Dim> inline constexpr bool found_anew<ProjectionMemory<Real, Dim>> = true;
// They tell about solves that have been made, and nothing about the next one.
template <> inline constexpr bool found_anew<DensityReport> = true;
template <> inline constexpr bool found_anew<DivergenceReport> = true;
}  // namespace detail

/// An incompressible fluid by DFSPH, as a scene file asks for it; walls are ghosts. Compiled for the plane and
/// for space in files of their own.
template <int Dim> std::unique_ptr<Simulation> make_dfsph(const SceneFile& file) {
    using W = CubicSpline<Dim>;
    using T = Terms<Dim, W>;
    using Real = float;
    const T terms(file);
    const W w = terms.kernel();
    // A column at rest falls freely until its pressures are found: by 0.05² of the support here, at most.
    constexpr double force_fraction = 0.05;
    return composed<Dim>(file, [&](auto named) {
        return Scene{Given<Positions<Dim>, Velocities<Dim>, Masses, Density>{},
                     Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses, BodyOfGhost,
                           PlaceInBody<Dim>>{},
                     Given<RigidBodies<Dim>>{},
                     Given<EmitterStates>{},
                     Given<OutflowStates>{},
                     named("neighbours", FindInGrid<Dim>{file.support}),
                     named("neighbours at walls", FindGhostsInGrid<Dim>{file.support}),
                     terms.at_bodies(ForgetForces<Dim>{}),
                     named("density", SphDensity<W>{w}),
                     named("density of walls", terms.at_walls(AddGhostDensity<W>{w})),
                     named("gradients", CollectGradients<W, Real>{w}),
                     named("divergence", ZeroDivergence<Dim, Real>{file.density}),
                     named("viscosity", terms.viscosity()),
                     named("viscosity of walls", terms.wall_viscosity()),
                     terms.viscosity_on_bodies(),
                     named("cohesion", terms.cohesion()),
                     named("gravity", Gravity<Dim>{terms.gravity()}),
                     terms.viscous_limit(),
                     ForceLimit<Dim>{file.support, force_fraction},
                     named("forces", Kick<Dim>{}),
                     named("pressure", ConstantDensity<Dim, Real>{file.density}),
                     named("pressure of divergence", AddPressureOfDivergence{}),
                     terms.at_bodies(PressureOnBodies<W>{w}),
                     named("inflow", terms.template hold_inflow<SetInflow<Dim>>()),
                     named("time step", Drift<Dim>{}),
                     named("constraints", terms.constraints()),
                     AdvectiveLimit<Dim>{file.spacing},
                     terms.at_bodies(KickBodies<Dim>{terms.gravity()}),
                     terms.at_bodies(terms.contacts()),
                     terms.at_bodies(DriftBodies<Dim>{}),
                     terms.at_bodies(CarryGhosts<Dim>{}),
                     terms.at_bodies(terms.body_limit())};
    });
}

}  // namespace plumbline
