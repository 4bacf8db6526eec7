#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += 2 (dim + 2) μ Σⱼ mⱼ/(ρᵢ ρⱼ) (vᵢⱼ·xᵢⱼ) / r² ∇ᵢωᵢⱼ,  vᵢⱼ = vᵢ − vⱼ            Monaghan 2005
/// Along xᵢⱼ: linear and angular momentum are conserved, a rigid motion is not braked, energy is only
/// lost. Beside the shear viscosity μ it has the bulk viscosity 5 μ / 3 in space, 2 μ in the plane.
/// Without the small number that is often added to r²: kernels flat at the centre keep the quotient
/// finite, coincident particles are left out, and 1 % of the squared support would take several per cent of μ.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct MonaghanViscosity {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;
    double mu;  // dynamic viscosity μ [Pa s]

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        const double factor = 2.0 * (dim + 2) * mu;
        parallel_for(x.size(), [&](std::size_t i) {
            a[i] +=
                factor * near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                    if (n.r == 0.0) return Vec<dim>::Zero();
                    const double approach = (v[i] - v[n.j]).dot(n.x);
                    return m[n.j] / (rho[i] * rho[n.j]) * approach / (n.r * n.r) * gradient(w, n);
                });
        });
    }
};

}  // namespace plumbline
