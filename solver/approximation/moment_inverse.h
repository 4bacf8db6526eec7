#pragma once

#include "solver/approximation/polynomial_basis.h"

#include <cmath>
#include <optional>
#include <span>

namespace plumbline {

/// A generalised inverse of a moment matrix M, safe where M is singular (adams2009 Sec. 3.3).
template <class Matrix> struct MomentInverse {
    Matrix inverse;
    int rank;
    double condition;  // ‖M‖₁ ‖inverse‖₁
};

/// A direction with less than this share of the weights is not resolved by the samples: rounding
/// leaves 1e-16 of it, so that six digits of the smallest direction kept are right.
inline constexpr double moment_cut_off = 1e-10;

/// Up to here Cholesky is used. For symmetric M, ‖M⁻¹‖₂ ≤ ‖M⁻¹‖₁ and maxₖ Mₖₖ ≤ ‖M‖₁; so the smallest
/// eigenvalue is at least 1e-8 maxₖ Mₖₖ, and the graded inverse would find full rank as well.
inline constexpr double well_conditioned = 1e8;

template <class Matrix> double one_norm(const Matrix& m) {
    return m.cwiseAbs().colwise().sum().maxCoeff();
}

/// M⁻¹ = L⁻ᵀ L⁻¹ with M = L Lᵀ, for symmetric M; empty unless M is well conditioned.
template <int N> std::optional<MomentInverse<Mat<N>>> cholesky_inverse(const Mat<N>& M) {
    Mat<N> L = M;
    Mat<N> Y = Mat<N>::Identity();  // L⁻ᵀ
    for (int c = 0; c < N; ++c) {
        for (int k = 0; k < c; ++k) {
            L.col(c) -= L(c, k) * L.col(k);
            Y.col(c) -= L(c, k) * Y.col(k);
        }
        if (!(L(c, c) > 0.0)) return std::nullopt;
        const double scale = 1.0 / std::sqrt(L(c, c));
        L.col(c) *= scale;
        Y.col(c) *= scale;
    }
    MomentInverse<Mat<N>> result{Mat<N>::Zero(), N, 0.0};
    for (int k = 0; k < N; ++k)
        for (int c = 0; c <= k; ++c) result.inverse.col(c) += Y(c, k) * Y.col(k);
    result.condition = one_norm(M) * one_norm(result.inverse);
    if (!(result.condition <= well_conditioned)) return std::nullopt;
    return result;
}

/// G with M G M = M, G M G = G, for symmetric M ≥ 0 of any rank, in which polynomials of low degree
/// have priority: block Cholesky by degree; each diagonal block, the Schur complement of the lower
/// degrees, is inverted on the eigenvectors above the cut-off only. A plain pseudo-inverse would
/// share what coplanar samples cannot resolve among all monomials, and off their plane it would
/// lose even the partition of unity; here constants are exact at every rank, and so is each linear
/// function that the samples resolve. `degree_ends`: the basis sizes of order 0, 1, …, ending with the
/// size of M. Empty where the lowest degree is not resolved at all: no weight, or not finite.
std::optional<MomentInverse<Eigen::MatrixXd>> graded_inverse(const Eigen::MatrixXd& M,
                                                             std::span<const int> degree_ends);

/// The inverse by Cholesky where that is safe, and the graded one elsewhere.
template <int N>
std::optional<MomentInverse<Mat<N>>> moment_inverse(const Mat<N>& M,
                                                    std::span<const int> degree_ends) {
    if (auto fast = cholesky_inverse<N>(M)) return fast;
    const auto safe = graded_inverse(M, degree_ends);
    if (!safe) return std::nullopt;
    return MomentInverse<Mat<N>>{safe->inverse, safe->rank, safe->condition};
}

}  // namespace plumbline
