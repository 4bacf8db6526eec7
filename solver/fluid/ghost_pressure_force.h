#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −Σₖ mₖ 2 max(0, pᵢ)/ρᵢ² ∇ᵢω(xᵢ − xₖ) over the ghosts k: each has the pressure and the density of
/// the particle that feels it, which adams2009 Sec. 6.3 leaves open: erratum 36. A wall pushes
/// and does not pull.                                                         Akinci et al. 2012
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct GhostPressureForce {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, GhostPositions<dim>, GhostMasses, Density, Pressure,
                             GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const GhostPositions<dim>& ghosts,
             const GhostMasses& m, const Density& rho, const Pressure& p,
             const GhostNeighbourhood<dim, Space>& near, Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            if (p[i] <= 0.0) return;
            const Vec<dim> towards = near.template sum<Vec<dim>>(
                x, Index(i), ghosts,
                [&](const auto& n) -> Vec<dim> { return m[n.j] * gradient(w, n); });
            a[i] -= 2.0 * p[i] / (rho[i] * rho[i]) * towards;
        });
    }
};

}  // namespace plumbline
