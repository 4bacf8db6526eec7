#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −Σⱼ mⱼ (pᵢ/ρᵢ² + pⱼ/ρⱼ²) ∇ᵢωᵢⱼ                                         adams2009 Eq. 51
/// mᵢ aᵢⱼ = −mⱼ aⱼᵢ along xᵢⱼ: linear and angular momentum are conserved for any masses, and with Eq. 5
/// of the same kernel the energy Σ m (v²/2 + e(ρ)), as time steps go to zero.
/// Not zero for a constant pressure where samples are irregular: that is what keeps them regular.
/// Below Eq. 51 the text has aᵢⱼ = −aⱼᵢ, true for equal masses only: erratum 19.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct PressureForce {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            const double own = p[i] / (rho[i] * rho[i]);
            a[i] -= near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                return m[n.j] * (own + p[n.j] / (rho[n.j] * rho[n.j])) * gradient(w, n);
            });
        });
    }
};

}  // namespace plumbline
