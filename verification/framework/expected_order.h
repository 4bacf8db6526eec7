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
};

/// What theory expects of the error of `approximation` when the spacing falls.
///
/// Taylor's theorem at a point with samples x_j in its support, f_j = Σ f⁽ᵐ⁾ (x_j − x)ᵐ / m!, turns
/// the error of the k-th derivative into moments of the weights. A method that reproduces
/// polynomials of degree n has no error from m ≤ n, so it is of order n + 1 − k; if the samples lie
/// symmetrically, moments with odd m − k vanish as well, and the order is even.
/// SPH reproduces no polynomial: a relative error ε of its sums stays, which depends on h / spacing
/// alone. Methods that annihilate constants (differences, quotients) err by ε h^(1−k), the others by
/// ε h^(−k); where samples are symmetric, the odd moments vanish here too.
/// ε itself falls if the support grows against the spacing: the sum averages samples whose
/// displacements are independent, ε ~ (spacing / h)^(dim/2 + 1). Halton points are taken to be as good.
/// Beside it stands the smoothing error h² of Eq. 2.
Study::Series expected_order(const Approximation& approximation, const Conditions& conditions);

}  // namespace verification
