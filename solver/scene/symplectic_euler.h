#pragma once

#include "solver/foundation/quantities.h"
#include "solver/foundation/sum.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// v(t + Δt) = v + Δt a,  x(t + Δt) = x + Δt v(t + Δt); then a = 0.        adams2009 Eqs. 58, 59
/// The last pass of a step. Each quantity of `Evolved` is advanced by its Rate in the same way:
/// q(t + Δt) = q + Δt dq/dt, with the rates of the old velocities: good for temperatures, not for
/// the density, which sound couples to the velocities. Of order 1; a mode of angular frequency ω is stable iff ω Δt ≤ 2.
/// adams2009 calls it explicit; it is semi-implicit, and bounds the error of the energy: erratum 37.
template <int Dim, class... Evolved> struct SymplecticEuler {
    using Reads = Quantities<>;
    using Writes = Quantities<Positions<Dim>, Velocities<Dim>, Accelerations<Dim>, Evolved...,
                              Rate<Evolved>...>;

    void run(double dt, Positions<Dim>& x, Velocities<Dim>& v, Accelerations<Dim>& a, Evolved&... q,
             Rate<Evolved>&... rate) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            v[i] += dt * a[i];
            x[i] += dt * v[i];
            a[i].setZero();
        }
        (advance(dt, q, rate), ...);
    }

private:
    template <class Q> static void advance(double dt, Q& q, Rate<Q>& rate) {
        for (std::size_t i = 0; i < q.size(); ++i) {
            q[i] += dt * rate[i];
            rate[i] = zero<typename Q::value_type>();
        }
    }
};

}  // namespace plumbline
