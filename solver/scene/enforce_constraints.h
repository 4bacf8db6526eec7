#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"
#include "solver/particles/solid.h"

#include <array>

namespace plumbline {

/// A solid that particles may not enter, and how they leave it.
template <int Dim> struct Constraint {
    Shape<Dim> shape;
    bool hollow = false;                   // the solid is all around the shape, and the fluid in it
    double restitution = 0.0;              // e, 0 ≤ e ≤ 1
    double friction = 0.0;                 // of Coulomb, μ ≥ 0; without it particles slip
    Vec<Dim> velocity = Vec<Dim>::Zero();  // of the surface [m/s]
};

/// What all solids together have taken over from particles since the start.
struct TakenBySolids {
    std::array<double, 3> momentum{};  // [kg m/s]
    double energy = 0.0;               // kinetic, as a solid at rest sees it [J]
};

/// What a contact adds to the velocity v relative to a surface with the outward normal n. What goes into
/// the surface turns round, v_n → −e v_n, by the impulse (1 + e)|v_n| per mass; what goes along it loses up to
/// μ times that impulse, and never turns round. Zero where v leads out.
template <int Dim>
Vec<Dim> rebound(const Vec<Dim>& v, const Vec<Dim>& n, double restitution, double friction) {
    const double inwards = -n.dot(v);
    if (inwards <= 0.0) return Vec<Dim>::Zero();
    const double push = (1.0 + restitution) * inwards;
    const Vec<Dim> sliding = v + inwards * n;
    const double speed = sliding.norm();
    const double kept = speed > friction * push ? 1.0 - friction * push / speed : 0.0;
    return push * n - (1.0 - kept) * sliding;
}

/// EnforceConstraints of adams2009 Algorithm 5, which leaves it open how: a particle in a solid is put onto the
/// nearest point of its surface, and its velocity changes as `rebound` says. Solids take their turns in order.
/// Ghosts hold a fluid back by its pressure, which a spray does not have; this stops single
/// particles, too. The solids take up the momentum. After the integrator.
template <int Dim> struct EnforceConstraints {
    using Reads = Quantities<Masses>;
    using Writes = Quantities<Positions<Dim>, Velocities<Dim>, TakenBySolids>;
    std::vector<Constraint<Dim>> constraints;

    void run(double, const Masses& m, Positions<Dim>& x, Velocities<Dim>& v,
             TakenBySolids& taken) const {
        std::vector<char> is_in(x.size());
        for (const Constraint<Dim>& c : constraints)
            std::visit(
                [&](const auto& shape) {
                    if (c.hollow)
                        enforce(Cavity{shape}, c, m, x, v, is_in, taken);
                    else
                        enforce(shape, c, m, x, v, is_in, taken);
                },
                c.shape);
    }

private:
    /// Few particles are in a solid: they are found by all threads, and served in their order.
    template <SignedDistance<Dim> S>
    static void enforce(const S& solid, const Constraint<Dim>& c, const Masses& m,
                        Positions<Dim>& x, Velocities<Dim>& v, std::vector<char>& is_in,
                        TakenBySolids& taken) {
        parallel_for(x.size(), [&](std::size_t i) {
            is_in[i] = solid.from_surface(x[i]).distance < 0.0 ? 1 : 0;
        });
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (is_in[i] == 0) continue;
            const FromSurface<Dim> at = solid.from_surface(x[i]);
            x[i] -= at.distance * at.normal;
            const Vec<Dim> before = v[i] - c.velocity;
            const Vec<Dim> change = rebound<Dim>(before, at.normal, c.restitution, c.friction);
            v[i] += change;
            for (int d = 0; d < Dim; ++d) taken.momentum[d] -= m[i] * change[d];
            taken.energy -= m[i] * change.dot(before + 0.5 * change);
        }
    }
};

}  // namespace plumbline
