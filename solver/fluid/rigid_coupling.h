#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/fluid/rigid_body.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// To which body a ghost belongs, by number; and where it is in the body at rest, from the centre.
struct BodyOfGhost : Each<Index, Ghosts> {
    static constexpr std::string_view name = "bodies of ghosts";
};
template <int Dim> struct PlaceInBody : Each<Vec<Dim>, Ghosts> {  // [m]
    static constexpr std::string_view name = "places in bodies";
};
/// The number of what does not move: ghosts of walls.
inline constexpr Index no_body = ~Index{0};

/// xₖ = X + R rₖ, vₖ = V + ω × (xₖ − X): ghosts go with their bodies. Before their neighbours are found.
template <int Dim> struct CarryGhosts {
    using Reads = Quantities<RigidBodies<Dim>, BodyOfGhost, PlaceInBody<Dim>>;
    using Writes = Quantities<GhostPositions<Dim>, GhostVelocities<Dim>>;

    void run(double, const RigidBodies<Dim>& bodies, const BodyOfGhost& of,
             const PlaceInBody<Dim>& place, GhostPositions<Dim>& x, GhostVelocities<Dim>& v) const {
        for (std::size_t k = 0; k < x.size(); ++k) {
            if (of[k] == no_body) continue;
            const RigidBody<Dim>& body = bodies[of[k]];
            const Vec<Dim> arm = body.rotation * place[k];
            x[k] = body.centre + arm;
            v[k] = body.velocity + turned<Dim>(body.spin, arm);
        }
    }
};

/// F = 0, T = 0: before the passes that add what the fluid does to bodies.
template <int Dim> struct ForgetForces {
    using Reads = Quantities<>;
    using Writes = Quantities<RigidBodies<Dim>>;
    void run(double, RigidBodies<Dim>& bodies) const {
        for (RigidBody<Dim>& body : bodies) body.force.setZero(), body.torque.setZero();
    }
};

/// F += −Σ Fᵢₖ and T += Σ (xₖ − X) × (−Fᵢₖ) over the ghosts k of a body and the particles i near them, Fᵢₖ the forces that
/// GhostPressureForce gives to particles: what the fluid gets, the body loses. adams2009 Sec. 6.3; Akinci et al. 2012
/// After ForgetForces.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct PressureOnBodies {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, GhostPositions<dim>,
                             GhostMasses, BodyOfGhost, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<RigidBodies<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const GhostPositions<dim>& ghosts, const GhostMasses& m_ghost,
             const BodyOfGhost& of, const GhostNeighbourhood<dim, Space>& near,
             RigidBodies<dim>& bodies) const {
        // In one order, for sums that do not depend on threads.
        for (Index i = 0; i < x.size(); ++i) {
            if (p[i] <= 0.0) continue;
            near.template sum<double>(x, i, ghosts, [&](const auto& n) -> double {
                if (of[n.j] == no_body) return 0.0;
                const Vec<dim> force =
                    m[i] * m_ghost[n.j] * 2.0 * p[i] / (rho[i] * rho[i]) * gradient(w, n);
                bodies[of[n.j]].push(force, ghosts[n.j]);
                return 0.0;
            });
        }
    }
};

/// Adds −Fᵢₖ, Fᵢₖ the forces that GhostViscosity gives to particles, and (xᵢ − X) × (−Fᵢₖ). They do not
/// point along xᵢ − xₖ: taken over at the ghost, a couple (xᵢ − xₖ) × Fᵢₖ would come from nowhere; taken over
/// at the particle, the fluid loses as much angular momentum as the body gets. After ForgetForces.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct ViscosityOnBodies {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, Masses, Density, GhostPositions<dim>,
                   GhostVelocities<dim>, GhostMasses, BodyOfGhost, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<RigidBodies<dim>>;
    K w;
    double mu;  // dynamic viscosity μ [Pa s]

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const GhostPositions<dim>& ghosts,
             const GhostVelocities<dim>& v_ghost, const GhostMasses& m_ghost, const BodyOfGhost& of,
             const GhostNeighbourhood<dim, Space>& near, RigidBodies<dim>& bodies) const {
        for (Index i = 0; i < x.size(); ++i)
            near.template sum<double>(x, i, ghosts, [&](const auto& n) -> double {
                if (of[n.j] == no_body || n.r == 0.0) return 0.0;
                const double strength =
                    m[i] * m_ghost[n.j] * mu / (rho[i] * rho[i]) * -2.0 * w.derivative(n.r) / n.r;
                bodies[of[n.j]].push(strength * (v[i] - v_ghost[n.j]), x[i]);
                return 0.0;
            });
    }
};

}  // namespace plumbline
