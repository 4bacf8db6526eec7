#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

struct Temperature : Each<double> {  // [K]
    static constexpr std::string_view name = "temperature";
};
struct Conductivity : Each<double> {  // k [W/(m K)]
    static constexpr std::string_view name = "conductivity";
};
struct HeatCapacity : Each<double> {  // c_p [J/(kg K)]
    static constexpr std::string_view name = "heat capacity";
};

/// dTᵢ/dt += 1/cᵢ Σⱼ mⱼ/(ρᵢ ρⱼ) 4 kᵢkⱼ/(kᵢ + kⱼ) (−ω′/r) (Tⱼ − Tᵢ)             Cleary and Monaghan 1999
/// The harmonic mean keeps the flux continuous where the conductivity jumps. Σ m c T is conserved, heat
/// flows from hot to cold, and no new extremum arises. Stable for Δt ≤ 0.04 ρ c h²/k, as ViscousLimit.
/// Pairs of two insulators, k = 0, exchange nothing.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct HeatConduction {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Temperature, Conductivity,
                             HeatCapacity, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Rate<Temperature>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Temperature& T, const Conductivity& k, const HeatCapacity& c,
             const Neighbourhood<dim, Space>& near, Rate<Temperature>& rate) const {
        parallel_for(x.size(), [&](std::size_t i) {
            const double heat =
                near.template sum<double>(x, Index(i), [&](const auto& n) -> double {
                    const double both = k[i] + k[n.j];
                    if (n.r == 0.0 || both == 0.0) return 0.0;
                    const double mean = 4.0 * k[i] * k[n.j] / both;
                    return m[n.j] / (rho[i] * rho[n.j]) * mean * (-w.derivative(n.r) / n.r) *
                           (T[n.j] - T[i]);
                });
            rate[i] += heat / c[i];
        });
    }
};

}  // namespace plumbline
