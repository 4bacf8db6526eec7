#pragma once

#include "solver/fluid/rigid_body.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/solid.h"

namespace plumbline {

/// What of a body can touch others: its shape, and the tips that meet a surface first, balls of one radius
/// around points, all from the centre of mass in the body at rest.
template <int Dim> struct Outline {
    Shape<Dim> shape;
    Points<Dim> tips = {};  // corners; of a ball the centre
    double radius = 0.0;    // of a ball [m]

    /// How far the body reaches from its centre [m].
    double reach() const {
        double farthest = 0.0;
        for (const Vec<Dim>& tip : tips) farthest = std::max(farthest, tip.norm());
        return farthest + radius;
    }
};
/// Of a box, a ball or a mesh that is where the body is at rest, its centre at 0.
/// Throws InvalidInput for a half-space, which no body is.
template <int Dim> Outline<Dim> outline_of(const Shape<Dim>& shape);

/// A solid that stands still, and bodies stay out of it, or in it if it is hollow.
template <int Dim> struct Obstacle {
    Shape<Dim> shape;
    bool hollow = false;
};

/// One solid, or for a hollow box one for each of its sides: in a corner more than the nearest one counts.
template <int Dim> std::vector<Obstacle<Dim>> obstacles_of(const Shape<Dim>& shape, bool hollow);

/// Contacts of bodies with each other and with obstacles. Where a tip would be in a surface after the step, with the
/// gap φ and the normal n towards the tip, impulses make the velocity u of the tip relative to the surface
/// u·n ≥ −φ/Δt, so that it arrives at most at the surface, or with a restitution e > 0 ≥ e |u·n|, so that it leaves
/// it; they act on both bodies at one point, so that linear and angular momentum stay. What only a push of the same
/// step drives into a surface arrives there without restitution. Friction follows Coulomb, with at most
/// μ times the normal impulse. All contacts are solved together by sweeps (projected Gauss-Seidel).
/// φ is convex for convex bodies: what moves without turning then never goes in. A turn by Δt ω brings a tip
/// at r up to r (Δt ω)²/2 in per step, of which a fifth is taken back in each step: r (5/2) (Δt ω)² at most.
/// Two edges that cross in space are not seen. Between KickBodies and DriftBodies.
template <int Dim> struct CollideBodies {
    using Reads = Quantities<>;
    using Writes = Quantities<RigidBodies<Dim>>;
    std::vector<Outline<Dim>> outlines = {};  // one for each body
    std::vector<Obstacle<Dim>> obstacles = {};
    double restitution = 0.0;  // e, 0 ≤ e ≤ 1
    double friction = 0.0;     // μ ≥ 0

    void run(double dt, RigidBodies<Dim>& bodies) const;
};

/// How far the shapes of the bodies reach into each other and into obstacles, at most [m]; < 0 where nothing touches.
template <int Dim>
double deepest_overlap(const CollideBodies<Dim>& contacts, const RigidBodies<Dim>& bodies);

}  // namespace plumbline
