#pragma once

#include "solver/foundation/types.h"

namespace verification {

/// λ₁ ≤ λ₂ ≤ … of a symmetric matrix of 2, 3 or 4 rows; of its lower triangle.
template <int N> plumbline::Vec<N> eigenvalues(const plumbline::Mat<N>& symmetric);

/// max |λ| of a square matrix.
double spectral_radius(const Eigen::MatrixXd& square);

}  // namespace verification
