#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// dρᵢ/dt += Σₖ mₖ (vᵢ − vₖ)·∇ᵢω(xᵢ − xₖ) over the ghosts k, vₖ the velocity of their body: the time
/// derivative of adams2009 Eq. 55. Beside Continuity: fluid that comes nearer to a wall is compressed.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct GhostContinuity {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Velocities<dim>, GhostPositions<dim>,
                             GhostVelocities<dim>, GhostMasses, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<Rate<Density>>;
    K w;

    void run(double, const Positions<dim>& x, const Velocities<dim>& v,
             const GhostPositions<dim>& ghosts, const GhostVelocities<dim>& v_ghost,
             const GhostMasses& m, const GhostNeighbourhood<dim, Space>& near,
             Rate<Density>& rate) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rate[i] += near.template sum<double>(x, Index(i), ghosts, [&](const auto& n) -> double {
                return m[n.j] * (v[i] - v_ghost[n.j]).dot(gradient(w, n));
            });
        });
    }
};

}  // namespace plumbline
