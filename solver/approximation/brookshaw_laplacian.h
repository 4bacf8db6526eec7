#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// (Δf)(xᵢ) ≈ 2 Σⱼ (fᵢ − fⱼ) ω′(r) / r Vⱼ with r = ‖xᵢ − xⱼ‖, coincident samples left out
/// Brookshaw 1985, Morris et al. 1997. `f`: n samples of unit U; result [U/m²]. Exactly zero for
/// constant f. Every pair is weighted by −2 ω′/r > 0, the same both ways: no new extremum arises from
/// diffusion with it, and Σᵢ Vᵢ (Δf)(xᵢ) vanishes to rounding.
template <RadialKernel K>
double laplacian_brookshaw(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                           Index i) {
    return 2.0 * sum<double>(s.neighbours.of(i), [&](Index j) {
               const double r = (s.x[i] - s.x[j]).norm();
               return r > 0.0 ? (f[i] - f[j]) * w.derivative(r) / r * s.V[j] : 0.0;
           });
}

}  // namespace plumbline
