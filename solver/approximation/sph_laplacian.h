#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// (Δf)(x) ≈ Σⱼ fⱼ Δω(‖x − xⱼ‖) Vⱼ                                          adams2009 Eq. 11
/// The exact Laplacian of `interpolate`: Δω = ω″ + (dim − 1) ω′/r, not ω″ as printed (erratum 17).
/// `f`: n samples of unit U; result [U/m²]. Not zero for constant f.
template <RadialKernel K>
double laplacian_summation(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                           const Place<K::dim>& at) {
    return sum<double>(at.neighbours, [&](Index j) {
        return f[j] * laplacian(w, (at.x - s.x[j]).norm()) * s.V[j];
    });
}

/// (Δf)(xᵢ) ≈ Σⱼ (fⱼ − fᵢ) Δω(‖xᵢ − xⱼ‖) Vⱼ, coincident samples left out      adams2009 Eq. 15
/// `f`: n samples of unit U; result [U/m²]. Exactly zero for constant f. Noisy, since Δω changes its
/// sign within the support: `laplacian_brookshaw` is the better one.
template <RadialKernel K>
double laplacian_difference(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                            Index i) {
    return sum<double>(s.neighbours.of(i), [&](Index j) {
        const double r = (s.x[i] - s.x[j]).norm();
        return r > 0.0 ? (f[j] - f[i]) * laplacian(w, r) * s.V[j] : 0.0;
    });
}

}  // namespace plumbline
