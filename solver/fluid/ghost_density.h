#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// mₖ = ρ₀ / Σₗ ω(xₖ − xₗ), over all ghosts l of a body: a wall of one layer weighs on the fluid as much as
/// one of the fluid's density would. adams2009 leaves the masses of ghosts open: erratum 36.
/// `lists` are the ghosts near each ghost, itself included.           Akinci et al. 2012
template <RadialKernel K>
std::vector<double> ghost_masses(const K& w, std::span<const Vec<K::dim>> ghosts,
                                 const NeighbourLists& lists, double rest_density) {
    const Neighbourhood<K::dim> near{lists, OpenSpace<K::dim>{}};
    std::vector<double> masses;
    for (Index k = 0; k < ghosts.size(); ++k)
        masses.push_back(rest_density / near.template sum<double>(ghosts, k, [&](const auto& n) {
            return w.value(n.r);
        }));
    return masses;
}

/// ρᵢ += Σₖ mₖ ω(‖xᵢ − xₖ‖) over the ghosts k.                                   adams2009 Eq. 55
/// After SphDensity, so that the fluid at a wall is not taken for a free surface.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct AddGhostDensity {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, GhostPositions<dim>, GhostMasses,
                             GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<Density>;
    K w;

    void run(double, const Positions<dim>& x, const GhostPositions<dim>& ghosts,
             const GhostMasses& m, const GhostNeighbourhood<dim, Space>& near, Density& rho) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rho[i] += near.template sum<double>(
                x, Index(i), ghosts, [&](const auto& n) { return m[n.j] * w.value(n.r); });
        });
    }
};

}  // namespace plumbline
