#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// (∇f)(xᵢ) ≈ 1/ρᵢ Σⱼ mⱼ (fⱼ − fᵢ) ∇ω(xᵢ − xⱼ)                               adams2009 Eq. 17
/// From ∇f = (∇(ρ f) − f ∇ρ) / ρ (Eq. 16). `m`: masses [kg], `rho`: densities [kg/m^dim], `f`:
/// samples of unit U, n each; result [U/m]. Exactly zero for constant f; not exact for linear f.
template <RadialKernel K>
Vec<K::dim> gradient_mass_weighted(const K& w, const Samples<K::dim>& s, std::span<const double> m,
                                   std::span<const double> rho, std::span<const double> f,
                                   Index i) {
    using V = Vec<K::dim>;
    return 1.0 / rho[i] * sum<V>(s.neighbours.of(i), [&](Index j) -> V {
               return m[j] * (f[j] - f[i]) * gradient(w, V(s.x[i] - s.x[j]));
           });
}

/// (∇f)(xᵢ) ≈ ρᵢ Σⱼ mⱼ (fⱼ/ρⱼ² + fᵢ/ρᵢ²) ∇ω(xᵢ − xⱼ)                         adams2009 Eq. 19
/// From ∇f = ρ (∇(f/ρ) + f/ρ² ∇ρ) (Eq. 18). Shapes and units as in `gradient_mass_weighted`. What
/// mᵢ/ρᵢ times it takes from sample i, it gives to others: the total vanishes to rounding. The price:
/// not zero for constant f. The sign between the two quotients is lost in the scan; Table 1 prints
/// Vⱼ for mⱼ: erratum 38.
template <RadialKernel K>
Vec<K::dim> gradient_symmetric(const K& w, const Samples<K::dim>& s, std::span<const double> m,
                               std::span<const double> rho, std::span<const double> f, Index i) {
    using V = Vec<K::dim>;
    const auto per_density_squared = [&](Index j) { return f[j] / (rho[j] * rho[j]); };
    const double f_i = per_density_squared(i);
    return rho[i] * sum<V>(s.neighbours.of(i), [&](Index j) -> V {
               return m[j] * (per_density_squared(j) + f_i) * gradient(w, V(s.x[i] - s.x[j]));
           });
}

}  // namespace plumbline
