#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/fluid/tait_equation.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// Which of several fluids a particle is of, by number.
struct Fluid : Each<Index> {
    static constexpr std::string_view name = "fluids";
};

/// ρᵢ = mᵢ Σⱼ ωᵢⱼ, particle i included: the number of particles per volume, times the mass of this one.
///                                                 Tartakovsky and Meakin 2005; Solenthaler and Pajarola 2008
/// Where fluids of different densities meet, Eq. 5 smears the jump over the support, and pressures with it; this
/// does not, if particles have equal volumes in both. In a single fluid of equal masses it is Eq. 5.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct NumberDensity {
    using Reads = Quantities<Positions<K::dim>, Masses, Neighbourhood<K::dim, Space>>;
    using Writes = Quantities<Density>;
    K w;

    void run(double, const Positions<K::dim>& x, const Masses& m,
             const Neighbourhood<K::dim, Space>& near, Density& rho) const {
        parallel_for(x.size(), [&](std::size_t i) {
            rho[i] = m[i] * near.template sum<double>(x, Index(i),
                                                      [&](const auto& n) { return w.value(n.r); });
        });
    }
};

/// pᵢ = p(ρᵢ) by the equation of the particle's own fluid.                     adams2009 Eq. 47
/// Throws InvalidInput where there is none for it.
struct TaitPressures {
    using Reads = Quantities<Density, Fluid>;
    using Writes = Quantities<Pressure>;
    std::vector<TaitEquation> equations;

    void run(double, const Density& rho, const Fluid& fluid, Pressure& p) const {
        for (std::size_t i = 0; i < rho.size(); ++i) {
            if (fluid[i] >= equations.size())
                throw InvalidInput("fluids: expected a number below " +
                                   std::to_string(equations.size()) + ", found " +
                                   std::to_string(fluid[i]) + " at particle " + std::to_string(i));
            p[i] = equations[fluid[i]].pressure(rho[i]);
        }
    }
};

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
