#pragma once

#include "solver/particles/solid.h"

namespace plumbline {

/// Integrals over a shape: ∫ dV, ∫ x dV over it, and ∫ (x − c)(x − c)ᵀ dV.
template <int Dim> struct Moments {
    double volume;    // [m^Dim]
    Vec<Dim> centre;  // c, of the volume [m]
    Mat<Dim> second;  // about c [m^(Dim + 2)]
};

/// Exact. Of a mesh as the sum over the tetrahedra from the origin to its triangles, with their corners a, b, c:
/// V = a·(b × c)/6, ∫ x xᵀ = V/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ), s = a + b + c.
/// Throws InvalidInput for a half-space, which has no volume.
template <int Dim> Moments<Dim> moments_of(const Shape<Dim>& shape);

/// The shape moved by `by` [m].
template <int Dim> Shape<Dim> moved(const Shape<Dim>& shape, const Vec<Dim>& by);

}  // namespace plumbline
