#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// ρᵢ = Σⱼ mⱼ ω(‖xᵢ − xⱼ‖), particle i included.                                 adams2009 Eq. 5
/// Mass is conserved exactly. Too small at a free surface: about 0.7 of the density inside.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct SphDensity {
    using Reads = Quantities<Positions<K::dim>, Masses, Neighbourhood<K::dim, Space>>;
    using Writes = Quantities<Density>;
    K w;

    void run(double, const Positions<K::dim>& x, const Masses& m,
             const Neighbourhood<K::dim, Space>& near, Density& rho) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rho[i] = near.template sum<double>(
                x, Index(i), [&](const auto& n) { return m[n.j] * w.value(n.r); });
        });
    }
};

}  // namespace plumbline
