#pragma once

#include "solver/fluid/body_contact.h"
#include "solver/scene/scene_file.h"
#include "solver/scene/time_step.h"

#include <algorithm>

namespace plumbline {

/// A body of a scene file at its start, and its outline.
template <int Dim> struct BodyAtStart {
    RigidBody<Dim> body;
    Outline<Dim> outline;
};
/// Its mass is that of the file, or density times volume; infinite if it is fixed.
template <int Dim> BodyAtStart<Dim> body_at_start(const SceneBody& body);

/// Where its ghosts stand at the start: on a lattice that fills a box with whole cells, and has a ball's centre
/// between its cells; to the depth of so many layers.
/// Throws InvalidInput, with the place in the file, for a box whose edges are no multiples of the spacing,
/// and for a body without ghosts.
template <int Dim> Points<Dim> ghosts_of(const SceneBody& body, double spacing, int layers);

/// Throws InvalidInput, with the place in the file, for bodies that overlap, or reach into walls.
template <int Dim>
void require_bodies_apart(const SceneFile& scene, const CollideBodies<Dim>& contacts);

/// The contacts of a scene's bodies: with each other, with its walls, and with its constraints.
template <int Dim> CollideBodies<Dim> contacts_of(const SceneFile& scene);

/// Δt ≤ C d / (V + ω r), r the reach of the body: no ghost moves by much of the spacing d in a step, nor does a
/// tip pass through another body, which is at least a spacing thick.
/// A light body on the fluid is a spring: 2 ρ c² g² dz over the depth of the support h on both sides, g the kernel's
/// integral across, stays below 2 ρ c² A/h for the area A, so that a body of density s ρ and length L has
/// (ω Δt)² ≤ 2 (c Δt)²/(s L h), which is below 4 for c Δt ≤ 0.4 h if s L ≥ 0.08 h: thinner ones need shorter steps.
template <int Dim> struct BodyLimit {
    using Reads = Quantities<RigidBodies<Dim>>;
    using Writes = Quantities<TimeStepLimits>;
    std::vector<Outline<Dim>> outlines;
    double spacing;         // d [m]
    double fraction = 0.4;  // C

    void run(double, const RigidBodies<Dim>& bodies, TimeStepLimits& limits) const {
        double fastest = 0.0;
        for (std::size_t k = 0; k < bodies.size(); ++k)
            fastest = std::max(
                fastest, bodies[k].velocity.norm() + bodies[k].spin.norm() * outlines[k].reach());
        limits.advective = fraction * spacing / fastest;
    }
};

}  // namespace plumbline
