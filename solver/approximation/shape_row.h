#pragma once

#include "solver/foundation/types.h"

#include <span>

namespace plumbline {

/// How many derivatives of the shape functions are wanted; each includes the ones before.
enum class Derivatives { none, gradient, laplacian };

/// The shape functions of the neighbours j of one point x, in the order of the neighbours:
/// Φⱼ(x) [1], ∇Φⱼ(x) [1/m], ΔΦⱼ(x) [1/m²]. A view of storage that the caller owns; a span of what
/// is not wanted is empty, and a Laplacian is only ever wanted with a gradient.
template <int Dim> struct ShapeRow {
    std::span<double> phi;
    std::span<Vec<Dim>> grad_phi;
    std::span<double> laplace_phi;
};

/// What the samples near one point allow: the shape functions reproduce as many independent
/// polynomials as the rank says.
struct Fit {
    int order;  // of the basis in use
    int rank;   // how many of its polynomials the samples can tell apart
    int size;   // how many polynomials it has
    double condition;  // ‖M‖₁ ‖M⁻¹‖₁ of the centred and scaled moment matrix that was inverted
    bool complete() const { return rank == size; }
};

}  // namespace plumbline
