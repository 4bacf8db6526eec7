#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// pᵢ ← ζ pᵢ where pᵢ < 0, 0 ≤ ζ ≤ 1: how much the fluid holds together under tension.  adams2009 Eq. 54
/// With ζ = 1 a stretched fluid clumps, with 0 it falls apart, which a flow with p < 0 inside, as a
/// rotating drop, does not survive.
struct ScaleTension {
    using Reads = Quantities<>;
    using Writes = Quantities<Pressure>;
    double zeta;

    void run(double, Pressure& p) const {
        for (double& p_i : p)
            if (p_i < 0.0) p_i *= zeta;
    }
};

}  // namespace plumbline
