#pragma once

#include "solver/approximation/samples.h"
#include "solver/kernels/kernel.h"

namespace plumbline {

/// Φⱼ(x) = Vⱼ ω(‖x − xⱼ‖), with which ⟨f⟩(x) = Σⱼ Φⱼ(x) fⱼ                  adams2009 Eqs. 39, 40
/// Dimensionless. Does not sum to one over j.
template <RadialKernel K>
double sph_shape_function(const K& w, const Samples<K::dim>& s, Index j, const Vec<K::dim>& x) {
    return s.V[j] * w.value((x - s.x[j]).norm());
}

/// ∇Φⱼ(x) = Vⱼ ∇ω(x − xⱼ) [1/m], with which (∇f)(x) ≈ Σⱼ ∇Φⱼ(x) fⱼ          adams2009 Eqs. 9, 40
template <RadialKernel K>
Vec<K::dim> sph_shape_gradient(const K& w, const Samples<K::dim>& s, Index j,
                               const Vec<K::dim>& x) {
    return s.V[j] * gradient(w, Vec<K::dim>(x - s.x[j]));
}

/// ΔΦⱼ(x) = Vⱼ Δω(‖x − xⱼ‖) [1/m²], with which (Δf)(x) ≈ Σⱼ ΔΦⱼ(x) fⱼ       adams2009 Eqs. 11, 40
template <RadialKernel K>
double sph_shape_laplacian(const K& w, const Samples<K::dim>& s, Index j, const Vec<K::dim>& x) {
    return s.V[j] * laplacian(w, (x - s.x[j]).norm());
}

}  // namespace plumbline
