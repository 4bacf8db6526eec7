#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += μ Σₖ mₖ/ρᵢ² (−2 ω′/r) (vₖ − vᵢ) over the ghosts k, vₖ the velocity of their body: the fluid sticks
/// to it. Without this pass it slips.                                          adams2009 Eq. 56
/// with the Laplacian of BrookshawViscosity, and the density of the particle for the ghost's.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct GhostViscosity {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, GhostPositions<dim>, GhostVelocities<dim>,
                   GhostMasses, Density, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;
    double mu;  // dynamic viscosity μ [Pa s]

    void run(double, const Positions<dim>& x, const Velocities<dim>& v,
             const GhostPositions<dim>& ghosts, const GhostVelocities<dim>& v_ghost,
             const GhostMasses& m, const Density& rho, const GhostNeighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            const Vec<dim> drag =
                near.template sum<Vec<dim>>(x, Index(i), ghosts, [&](const auto& n) -> Vec<dim> {
                    if (n.r == 0.0) return Vec<dim>::Zero();
                    return -2.0 * w.derivative(n.r) / n.r * m[n.j] * (v_ghost[n.j] - v[i]);
                });
            a[i] += mu / (rho[i] * rho[i]) * drag;
        });
    }
};

}  // namespace plumbline
