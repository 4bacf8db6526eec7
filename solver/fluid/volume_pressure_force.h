#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −1/mᵢ Σⱼ (pᵢ Vᵢ² + pⱼ Vⱼ²) ∇ᵢωᵢⱼ with V = m/ρ                              Tartakovsky and Meakin 2005
/// Beside NumberDensity, whose energy it is the slope of. mᵢ aᵢⱼ = −mⱼ aⱼᵢ along xᵢⱼ: linear and angular momentum are
/// conserved for any masses. In a single fluid of equal masses it is Eq. 51.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct VolumePressureForce {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        const auto of = [&](std::size_t i) {
            const double V = m[i] / rho[i];
            return p[i] * V * V;
        };
        parallel_for(x.size(), [&](std::size_t i) {
            const double own = of(i);
            const Vec<dim> force = near.template sum<Vec<dim>>(
                x, Index(i),
                [&](const auto& n) -> Vec<dim> { return (own + of(n.j)) * gradient(w, n); });
            a[i] -= force / m[i];
        });
    }
};

}  // namespace plumbline
