#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// dρᵢ/dt += δ h c Σⱼ 2 (ρⱼ − ρᵢ) (−ω′/r) mⱼ/ρⱼ                          Molteni and Colagrossi 2009
/// with their smoothing length h, taken as support / 2: smooths the noise of the pressure that weak
/// compressibility has. Beside Continuity. Σ (m/ρ) dρ/dt = 0, and no new extremum of ρ arises. Where ρ
/// has a slope, as under gravity, it pulls the free surface up.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct DensityDiffusion {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Rate<Density>>;
    K w;
    double delta;           // strength δ, 0.1 as a rule
    double speed_of_sound;  // c [m/s]

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Neighbourhood<dim, Space>& near, Rate<Density>& rate) const {
        const double strength = delta * 0.5 * w.support() * speed_of_sound;
        parallel_for(x.size(), [&](std::size_t i) {
            rate[i] +=
                strength * near.template sum<double>(x, Index(i), [&](const auto& n) -> double {
                    if (n.r == 0.0) return 0.0;
                    const double laplacian = -2.0 * w.derivative(n.r) / n.r;
                    return m[n.j] / rho[n.j] * laplacian * (rho[n.j] - rho[i]);
                });
        });
    }
};

}  // namespace plumbline
