#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// ⟨f⟩(x) = Σⱼ fⱼ ω(‖x − xⱼ‖) Vⱼ                                             adams2009 Eq. 3
/// `f`: n samples of unit U; result [U]. Not exact even for constant f, since the weights ω V do not
/// sum to one: only nearly so in the bulk of a lattice, and far less at a free surface. 0 where no
/// sample is near.
template <RadialKernel K>
double interpolate(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                   const Place<K::dim>& at) {
    return sum<double>(at.neighbours,
                       [&](Index j) { return f[j] * w.value((at.x - s.x[j]).norm()) * s.V[j]; });
}

}  // namespace plumbline
