#pragma once

#include "solver/fluid/rigid_coupling.h"
#include "solver/fluid/tait_equation.h"
#include "solver/particles/box.h"
#include "solver/particles/quantities.h"
#include "solver/particles/solid.h"
#include "solver/scene/enforce_constraints.h"
#include "solver/scene/scene_file.h"

namespace plumbline {

/// The particles and ghosts of a scene file at its start.
template <int Dim> struct Start {
    Positions<Dim> x;
    Velocities<Dim> v;
    Masses m;
    Density rho;
    GhostPositions<Dim> ghosts;
    GhostVelocities<Dim> ghost_velocities;
    GhostMasses ghost_masses;
    RigidBodies<Dim> bodies;
    BodyOfGhost body_of_ghost;
    PlaceInBody<Dim> places;
};

/// Each particle has the mass ρ d^Dim (on a hexagonal lattice √3/2 of that), d the spacing, with ρ = ρ₀ or, in a
/// hydrostatic block, ρ(p) at its depth; for Method::dfsph that with which a lattice has the density ρ₀ to the last
/// bit. Ghosts have ρ₀ d^Dim, in layers of a lattice that goes on where a
/// lattice of fluid inside would end. Particles closer than 0.7 d to a ghost of a body, or in a body, are left out.
/// Throws InvalidInput as make_simulation does.
template <int Dim> Start<Dim> start_of(const SceneFile& scene);

/// Throws InvalidInput for a mesh that nobody has read.
template <int Dim> Shape<Dim> shape_of(const SolidShape& solid);

/// The mass of a particle of a lattice [kg].
template <int Dim> double mass_of_particle(const SceneFile& scene);

/// What particles may not enter: each closed side of a tank is a plane without end, and so is a plane; and the
/// constraints.
template <int Dim> std::vector<Constraint<Dim>> solids_of(const SceneFile& scene);

inline TaitEquation tait_of(const SceneFile& scene) {
    return TaitEquation(scene.density, scene.speed_of_sound, scene.exponent);
}

}  // namespace plumbline
