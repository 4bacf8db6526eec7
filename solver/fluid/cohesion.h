#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// How strongly particles at the distance r attract each other: with q = r/h
///   C = 64 q³ (1 − q)³             for q > 1/2,  at most 1, at q = 1/2
///   C = 128 q³ (1 − q)³ − 1        for q ≤ 1/2,  repulsion below q = 0.27
/// and 0 from h on; of Akinci et al. 2013, Eq. 2, without its factor 1/(2π h³).
inline double cohesion_of_distance(double r, double support) {
    const double q = r / support;
    if (q >= 1.0) return 0.0;
    const double s = 4.0 * q * (1.0 - q), cube = s * s * s;
    return q > 0.5 ? cube : 2.0 * cube - 1.0;
}

/// aᵢ += −γ Σⱼ mⱼ 2ρ₀/(ρᵢ + ρⱼ) C(r)/(2π h^dim) xᵢⱼ/r                            Akinci et al. 2013, Eqs. 1, 2, 5
/// Particles hold together, and those at a surface, whose neighbours are all on one side, are pulled inwards: free
/// surfaces become small. The factor of the densities makes up for the neighbours that are missing there.
/// Linear and angular momentum are conserved. What tension of the surface a γ means is to be measured.
template <int Dim, class Space = OpenSpace<Dim>> struct Cohesion {
    using Reads = Quantities<Positions<Dim>, Masses, Density, Neighbourhood<Dim, Space>>;
    using Writes = Quantities<Accelerations<Dim>>;
    double support;       // h [m]
    double rest_density;  // ρ₀ [kg/m^Dim]
    double gamma;         // γ [m^(Dim + 1)/(kg s²)]

    void run(double, const Positions<Dim>& x, const Masses& m, const Density& rho,
             const Neighbourhood<Dim, Space>& near, Accelerations<Dim>& a) const {
        constexpr double two_pi = 6.283185307179586;
        const double strength = gamma * 2.0 * rest_density / (two_pi * std::pow(support, Dim));
        parallel_for(x.size(), [&](std::size_t i) {
            a[i] -= near.template sum<Vec<Dim>>(x, Index(i), [&](const auto& n) -> Vec<Dim> {
                if (n.r == 0.0) return Vec<Dim>::Zero();
                const double C = cohesion_of_distance(n.r, support);
                return strength * m[n.j] / (rho[i] + rho[n.j]) * C / n.r * n.x;
            });
        });
    }
};

}  // namespace plumbline
