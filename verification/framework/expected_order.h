#pragma once

#include "verification/framework/approximation_errors.h"
#include "verification/framework/study.h"

namespace verification {

/// Under which conditions an order of convergence is asked for: the support grows as
/// h ~ spacing^support_exponent; 1 keeps h / spacing fixed.
struct Conditions {
    int dim;
    Sampling sampling;
    Region region;
    double support_exponent = 1.0;
    MeasuredAt measured_at = MeasuredAt::samples;
    Norm norm = Norm::l2;
};

/// What theory expects of the error of `approximation` when the spacing falls.
///
/// Taylor's theorem at a point with samples x_j in its support, f_j = Σ f⁽ᵐ⁾ (x_j − x)ᵐ / m!, turns
/// the error of the k-th derivative into moments of the weights. A method that reproduces
/// polynomials of degree n has no error from m ≤ n, so it is of order n + 1 − k; if the samples lie
/// symmetrically, as around a point of a lattice, moments with odd m − k vanish as well, and the
/// order is even. Disorder, and places between the points of a lattice, leave odd moments that are
/// small against the even ones: the error is a sum of both orders.
/// SPH reproduces no polynomial: a relative error ε of its sums stays, which depends on h / spacing
/// alone. Methods that annihilate constants (differences, quotients) err by ε h^(1−k), the others by
/// ε h^(−k); where samples are symmetric, the odd moments vanish here too.
/// ε itself falls if the support grows against the spacing. Disordered samples: the sum averages
/// displacements that are independent, ε ~ (spacing / h)^(dim/2 + 1); Halton points are taken to be as
/// good. Lattice: ε is the Fourier transform of the kernel at the reciprocal lattice, which falls with a
/// high power of spacing / h but goes up and down under it; of values it is below the smoothing error.
/// Beside it stands the smoothing error of Eq. 2, h², which MLS of degree 2 and 3 lower to h⁴ for all
/// derivatives: with infinitely many samples each method is a convolution. At a boundary samples lie
/// on one side only: ε does not fall. Throws std::logic_error for an unknown method, and for a
/// derivative on a lattice with a growing support.
Study::Series expected_order(const Approximation& approximation, const Conditions& conditions);

}  // namespace verification
