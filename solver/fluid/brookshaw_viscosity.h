#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += μ Σⱼ mⱼ/(ρᵢ ρⱼ) (−2 ω′/r) (vⱼ − vᵢ)      Brookshaw 1985, Morris et al. 1997; adams2009 Eq. 52
/// with a Laplacian of the kernel that is positive and accurate, and both densities, which adams2009
/// leaves out: erratum 18. Linear momentum is conserved, energy only lost, to viscosity; angular
/// momentum is not conserved, since the force is not along xᵢⱼ.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct BrookshawViscosity {
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
                if (n.r == 0.0) return Vec<dim>::Zero();
                const double laplacian = -2.0 * w.derivative(n.r) / n.r;
                return m[n.j] / (rho[i] * rho[n.j]) * laplacian * (v[n.j] - v[i]);
            });
        });
    }
};

}  // namespace plumbline
