#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −Σⱼ mⱼ (pᵢ + pⱼ) / (ρᵢ ρⱼ) ∇ᵢωᵢⱼ                      adams2009 Sec. 6.1, below Eq. 50
/// The "simple way" to make Eq. 50 symmetric, without the 1/2 of the text, which halves the force: erratum 61.
/// Linear and angular momentum are conserved because both densities stand in the denominator; with ρⱼ
/// alone they are not. Where densities jump, it is smoother than Eq. 51.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct AveragedPressureForce {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            a[i] -= near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                return m[n.j] * (p[i] + p[n.j]) / (rho[i] * rho[n.j]) * gradient(w, n);
            });
        });
    }
};

}  // namespace plumbline
