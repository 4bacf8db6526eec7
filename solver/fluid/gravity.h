#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// The external force of adams2009 Eqs. 44, 48, the same acceleration g [m/s²] for every particle.
/// Algorithm 5 prints no external force at all: erratum 31.
template <int Dim> struct Gravity {
    using Reads = Quantities<>;
    using Writes = Quantities<Accelerations<Dim>>;
    Vec<Dim> g;

    void run(double, Accelerations<Dim>& a) const {
        for (Vec<Dim>& a_i : a) a_i += g;
    }
};

}  // namespace plumbline
