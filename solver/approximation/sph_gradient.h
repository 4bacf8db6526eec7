#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// (∇f)(x) ≈ Σⱼ fⱼ ∇ω(x − xⱼ) Vⱼ                                             adams2009 Eq. 9
/// The exact derivative of `interpolate`. `f`: n samples of unit U; result [U/m]. Not zero for
/// constant f: on disordered samples the error grows as the spacing and the support shrink together.
template <RadialKernel K>
Vec<K::dim> gradient_summation(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                               const Place<K::dim>& at) {
    using V = Vec<K::dim>;
    return sum<V>(at.neighbours,
                  [&](Index j) -> V { return f[j] * s.V[j] * gradient(w, V(at.x - s.x[j])); });
}

/// (∇f)(xᵢ) ≈ Σⱼ (fⱼ − fᵢ) ∇ω(xᵢ − xⱼ) Vⱼ                                    adams2009 Eq. 13
/// `f`: n samples of unit U; result [U/m]. Exactly zero for constant f; not exact for linear f.
template <RadialKernel K>
Vec<K::dim> gradient_difference(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                                Index i) {
    using V = Vec<K::dim>;
    return sum<V>(s.neighbours.of(i), [&](Index j) -> V {
        return (f[j] - f[i]) * s.V[j] * gradient(w, V(s.x[i] - s.x[j]));
    });
}

}  // namespace plumbline
