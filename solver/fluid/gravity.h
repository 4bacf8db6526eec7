#pragma once

#include "solver/foundation/parallel.h"
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
        parallel_for_parts(a.size(), [&](std::size_t first, std::size_t last) {
            const Vec<Dim> all = g;  // a copy, which what is written cannot change
            for (std::size_t i = first; i < last; ++i) a[i] += all;
        });
    }
};

}  // namespace plumbline
