#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// aᵢ += −Σⱼ mⱼ Πᵢⱼ ∇ᵢωᵢⱼ with Πᵢⱼ = −α c h μᵢⱼ/ρ̄ᵢⱼ where particles approach, 0 where they separate;
/// μᵢⱼ = vᵢⱼ·xᵢⱼ / (r² + 0.01 h²), ρ̄ᵢⱼ = (ρᵢ + ρⱼ) / 2                                Monaghan 1992
/// with the smoothing length h of that text, half of the support for kernels like the cubic spline: it
/// is taken as support / 2 here. Acts like a kinematic viscosity α c h / (2 (dim + 2)) in compression.
/// Linear and angular momentum are conserved, energy is only lost.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct ArtificialViscosity {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;
    double alpha;           // strength α, 0.01 to 1
    double speed_of_sound;  // c [m/s]

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const Neighbourhood<dim, Space>& near,
             Accelerations<dim>& a) const {
        const double h = 0.5 * w.support(), strength = alpha * speed_of_sound * h;
        parallel_for(x.size(), [&](std::size_t i) {
            a[i] += near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                const double approach = (v[i] - v[n.j]).dot(n.x);
                if (approach >= 0.0) return Vec<dim>::Zero();
                const double mu = approach / (n.r * n.r + 0.01 * h * h);
                return m[n.j] * strength * mu / (0.5 * (rho[i] + rho[n.j])) * gradient(w, n);
            });
        });
    }
};

}  // namespace plumbline
