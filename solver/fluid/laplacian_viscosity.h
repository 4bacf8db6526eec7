#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += μ Σⱼ mⱼ/(ρᵢ ρⱼ) Δωᵢⱼ (vⱼ − vᵢ)                                         adams2009 Eq. 52
/// Printed with ρⱼ alone, which loses linear momentum, and ω″ for Δω: errata 17, 18. Angular momentum
/// is not conserved by either. Meant for kernels with Δω ≥ 0, as Viscosity (Müller et al. 2003): with one
/// that changes its sign, as poly6, some velocities grow at any time step.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct LaplacianViscosity {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;
    double mu;  // dynamic viscosity μ [Pa s]

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            a[i] += mu * near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                return m[n.j] / (rho[i] * rho[n.j]) * laplacian(w, n.r) * (v[n.j] - v[i]);
            });
        });
    }
};

}  // namespace plumbline
