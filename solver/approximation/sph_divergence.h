#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// (∇·f)(x) ≈ Σⱼ fⱼ · ∇ω(x − xⱼ) Vⱼ                                         adams2009 Eq. 12
/// `f`: n vectors of unit U; result [U/m]. Not zero for constant f: the trace of `gradient_summation`.
template <RadialKernel K>
double divergence_summation(const K& w, const Samples<K::dim>& s, std::span<const Vec<K::dim>> f,
                            const Place<K::dim>& at) {
    using V = Vec<K::dim>;
    return sum<double>(at.neighbours,
                       [&](Index j) { return f[j].dot(gradient(w, V(at.x - s.x[j]))) * s.V[j]; });
}

/// (∇·f)(xᵢ) ≈ Σⱼ (fⱼ − fᵢ) · ∇ω(xᵢ − xⱼ) Vⱼ                                 adams2009 Eq. 14
/// `f`: n vectors of unit U; result [U/m]. Exactly zero for constant f and, to rounding, for rigid
/// rotations; not exact for other linear f.
template <RadialKernel K>
double divergence_difference(const K& w, const Samples<K::dim>& s, std::span<const Vec<K::dim>> f,
                             Index i) {
    using V = Vec<K::dim>;
    return sum<double>(s.neighbours.of(i), [&](Index j) {
        return (f[j] - f[i]).dot(gradient(w, V(s.x[i] - s.x[j]))) * s.V[j];
    });
}

}  // namespace plumbline
