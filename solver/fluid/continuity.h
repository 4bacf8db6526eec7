#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// dρᵢ/dt += Σⱼ mⱼ (vᵢ − vⱼ)·∇ᵢωᵢⱼ: the time derivative of adams2009 Eq. 5               Monaghan 1992
/// For densities that are advanced in time instead of summed: correct at free surfaces, where the sum
/// is too small, and open to diffusion. To be advanced by TwoStage or Leapfrog:
/// SymplecticEuler advances density and velocity together, which makes sound waves grow at any time
/// step. What rounding and time steps take from ρ is never given back.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct Continuity {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Velocities<dim>, Masses, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Rate<Density>>;
    K w;

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Neighbourhood<dim, Space>& near, Rate<Density>& rate) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rate[i] += near.template sum<double>(x, Index(i), [&](const auto& n) -> double {
                return m[n.j] * (v[i] - v[n.j]).dot(gradient(w, n));
            });
        });
    }
};

}  // namespace plumbline
