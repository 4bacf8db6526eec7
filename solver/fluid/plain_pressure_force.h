#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −(1/ρᵢ) Σⱼ mⱼ pⱼ/ρⱼ ∇ᵢωᵢⱼ                                              adams2009 Eq. 50
/// The gradient of Eq. 9, for comparison: neither linear nor angular momentum is conserved.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct PlainPressureForce {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            const Vec<dim> gradient_of_p =
                near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                    return m[n.j] * p[n.j] / rho[n.j] * gradient(w, n);
                });
            a[i] -= gradient_of_p / rho[i];
        });
    }
};

}  // namespace plumbline
