#pragma once

#include "solver/fluid/ghost_density.h"
#include "solver/fluid/ghost_xsph.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/tension.h"
#include "solver/fluid/xsph.h"
#include "solver/scene/composed.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"
#include "solver/scene/terms.h"

namespace plumbline {

/// adams2009 Algorithm 5 as a scene file asks for it: densities as sums, walls of ghosts (Sec. 6.3), and what it leaves
/// out, gravity (erratum 31) and viscosity. Compiled for the plane and for space in files of their own.
template <int Dim> std::unique_ptr<Simulation> make_sph(const SceneFile& file) {
    using T = Terms<Dim>;
    using W = typename T::W;
    const T terms(file);
    const W w = terms.kernel();
    const bool smoothed = file.xsph > 0.0, moved = smoothed && file.xsph_form == XsphForm::motion;
    return composed<Dim>(file, [&](auto named) {
        return Scene{
            Given<Positions<Dim>, Velocities<Dim>, Masses, Density>{},
            Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses, BodyOfGhost,
                  PlaceInBody<Dim>>{},
            Given<RigidBodies<Dim>>{},
            Given<EmitterStates>{},
            Given<OutflowStates>{},
            named("neighbours", FindInGrid<Dim>{file.support}),
            named("neighbours at walls", terms.at_walls(FindGhostsInGrid<Dim>{file.support})),
            named("density", SphDensity<W>{w}),
            named("density of walls", terms.at_walls(AddGhostDensity<W>{w})),
            named("pressure", TaitPressure{tait_of(file)}),
            named("scaling of tension", ScaleTension{file.tension}),
            named("pressure force", terms.pressure_force()),
            named("pressure force of walls", terms.at_walls(GhostPressureForce<W>{w})),
            terms.at_bodies(ForgetForces<Dim>{}),
            terms.at_bodies(PressureOnBodies<W>{w}),
            named("viscosity", terms.viscosity()),
            named("viscosity of walls", terms.wall_viscosity()),
            terms.viscosity_on_bodies(),
            named("XSPH", T::only_if(smoothed, AverageVelocities<W>{w})),
            named("XSPH of walls",
                  T::only_if(smoothed && file.no_slip, AverageGhostVelocities<W>{w})),
            named("XSPH",
                  T::only_if(smoothed && !moved, XsphVelocities<Dim>{{file.xsph, file.xsph_step}})),
            named("XSPH", T::only_if(moved, XsphMotion<Dim>{file.xsph})),
            named("cohesion", terms.cohesion()),
            named("gravity", Gravity<Dim>{terms.gravity()}),
            named("inflow", terms.template hold_inflow<HoldInflow<Dim>>()),
            terms.acoustic_limit(),
            terms.viscous_limit(),
            terms.force_limit(),
            named("time step", SymplecticEuler<Dim>{}),
            named("constraints", terms.constraints()),
            terms.at_bodies(KickBodies<Dim>{terms.gravity()}),
            terms.at_bodies(terms.contacts()),
            terms.at_bodies(DriftBodies<Dim>{}),
            terms.at_bodies(CarryGhosts<Dim>{}),
            terms.at_bodies(terms.body_limit())};
    });
}

}  // namespace plumbline
