#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/fluid/xsph.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// Adds Σₖ mₖ/ρᵢ ω(xᵢ − xₖ) (vₖ − vᵢ) over the ghosts k to the average of XSPH: the fluid sticks to the body.
/// After AverageVelocities.                                                    adams2009 Eq. 57
/// in the form of differences, as there: printed, uniform motion is not left alone, erratum 20.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct AverageGhostVelocities {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, GhostPositions<dim>, GhostVelocities<dim>,
                   GhostMasses, Density, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<VelocityTowardsMean<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Velocities<dim>& v,
             const GhostPositions<dim>& ghosts, const GhostVelocities<dim>& v_ghost,
             const GhostMasses& m, const Density& rho, const GhostNeighbourhood<dim, Space>& near,
             VelocityTowardsMean<dim>& towards) const {
        parallel_for(x.size(), [&](std::size_t i) {
            towards[i] +=
                near.template sum<Vec<dim>>(x, Index(i), ghosts, [&](const auto& n) -> Vec<dim> {
                    return m[n.j] / rho[i] * w.value(n.r) * (v_ghost[n.j] - v[i]);
                });
        });
    }
};

}  // namespace plumbline
