#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// The points x with ⟨n, x − point⟩ ≥ 0; n has the length 1.
template <int Dim> struct HalfSpace {
    Vec<Dim> point;  // [m]
    Vec<Dim> n;
};

/// EnforceConstraints of adams2009 Algorithm 5, which leaves it open how: a particle behind a wall is put back
/// onto it, and the part of its velocity that goes into the wall turns round, v_n → −e v_n.
/// Ghosts hold a fluid back by its pressure, which a spray does not have; this stops single
/// particles, too. The wall takes up the momentum. After the integrator.
template <int Dim> struct EnforceConstraints {
    using Reads = Quantities<>;
    using Writes = Quantities<Positions<Dim>, Velocities<Dim>>;
    std::vector<HalfSpace<Dim>> walls;
    double restitution = 0.0;  // e, 0 ≤ e ≤ 1

    void run(double, Positions<Dim>& x, Velocities<Dim>& v) const {
        for (const HalfSpace<Dim>& wall : walls)
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double depth = -wall.n.dot(x[i] - wall.point);
                if (depth <= 0.0) continue;
                x[i] += depth * wall.n;
                const double inwards = -wall.n.dot(v[i]);
                if (inwards > 0.0) v[i] += (1.0 + restitution) * inwards * wall.n;
            }
    }
};

}  // namespace plumbline
