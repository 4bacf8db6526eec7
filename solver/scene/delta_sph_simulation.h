#pragma once

#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/ghost_continuity.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/tension.h"
#include "solver/scene/composed.h"
#include "solver/scene/scene.h"
#include "solver/scene/terms.h"
#include "solver/scene/two_stage.h"

namespace plumbline {

/// Densities that follow continuity and are smoothed by diffusion, walls of ghosts, two stages per step, as
/// a scene file asks for it. Compiled for the plane and for space in files of their own.
template <int Dim> std::unique_ptr<Simulation> make_delta_sph(const SceneFile& file) {
    using T = Terms<Dim>;
    using W = typename T::W;
    const T terms(file);
    const W w = terms.kernel();
    return composed<Dim>(file, [&](auto named) {
        return Scene{
            Given<Positions<Dim>, Velocities<Dim>, Masses, Density>{},
            Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses, BodyOfGhost,
                  PlaceInBody<Dim>>{},
            Given<RigidBodies<Dim>>{},
            Given<EmitterStates>{},
            Given<OutflowStates>{},
            TwoStage{
                Evolve<Dim, Density>{}, named("neighbours", FindInGrid<Dim>{file.support}),
                named("neighbours at walls", terms.at_walls(FindGhostsInGrid<Dim>{file.support})),
                named("continuity", Continuity<W>{w}),
                named("continuity at walls", terms.at_walls(GhostContinuity<W>{w})),
                named("diffusion of density",
                      T::only_if(file.diffusion > 0.0,
                                 DensityDiffusion<W>{w, file.diffusion, file.speed_of_sound})),
                named("pressure", TaitPressure{tait_of(file)}),
                named("scaling of tension", ScaleTension{file.tension}),
                named("pressure force", terms.pressure_force()),
                named("pressure force of walls", terms.at_walls(GhostPressureForce<W>{w})),
                terms.at_bodies(ForgetForces<Dim>{}), terms.at_bodies(PressureOnBodies<W>{w}),
                named("viscosity", terms.viscosity()),
                named("viscosity of walls", terms.wall_viscosity()), terms.viscosity_on_bodies(),
                named("cohesion", terms.cohesion()),
                named("gravity", Gravity<Dim>{terms.gravity()}),
                named("inflow", terms.template hold_inflow<HoldInflow<Dim>>())},
            named("time step", Inspect<Positions<Dim>, Velocities<Dim>, Density>{}),
            named("constraints", terms.constraints()),
            terms.acoustic_limit(),
            terms.viscous_limit(),
            terms.force_limit(),
            terms.at_bodies(KickBodies<Dim>{terms.gravity()}),
            terms.at_bodies(terms.contacts()),
            terms.at_bodies(DriftBodies<Dim>{}),
            terms.at_bodies(CarryGhosts<Dim>{}),
            terms.at_bodies(terms.body_limit())};
    });
}

}  // namespace plumbline
