#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// ρᵢ = mᵢ Σⱼ ωᵢⱼ, particle i included: the number of particles per volume, times the mass of this one.
///                                                 Tartakovsky and Meakin 2005; Solenthaler and Pajarola 2008
/// Where fluids of different densities meet, Eq. 5 smears the jump over the support, and pressures with it; this
/// does not, if particles have equal volumes in both. In a single fluid of equal masses it is Eq. 5.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct NumberDensity {
    using Reads = Quantities<Positions<K::dim>, Masses, Neighbourhood<K::dim, Space>>;
    using Writes = Quantities<Density>;
    K w;

    void run(double, const Positions<K::dim>& x, const Masses& m,
             const Neighbourhood<K::dim, Space>& near, Density& rho) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rho[i] = m[i] * near.template sum<double>(x, Index(i),
                                                      [&](const auto& n) { return w.value(n.r); });
        });
    }
};

}  // namespace plumbline
