#include "solver/approximation/moment_inverse.h"

#include <Eigen/SVD>
#include <limits>

namespace plumbline {

std::optional<MomentInverse<Eigen::MatrixXd>> graded_inverse(const Eigen::MatrixXd& M,
                                                             std::span<const int> degree_ends) {
    using Eigen::MatrixXd;
    const double largest = M.diagonal().maxCoeff();
    if (!M.allFinite() || !(largest >= std::numeric_limits<double>::min())) return std::nullopt;
    const Eigen::Index N = M.rows();
    MomentInverse<MatrixXd> result{MatrixXd::Zero(N, N), 0, 0.0};
    MatrixXd schur = M, T = MatrixXd::Identity(N, N);  // Tᵀ M T is block diagonal
    Eigen::Index begin = 0;
    for (const Eigen::Index end : degree_ends) {
        const Eigen::Index n = end - begin, rest = N - end;
        // A block is symmetric and, but for rounding far below the cut-off, has no negative eigenvalue:
        // then its singular vectors are its eigenvectors.
        const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(
            schur.block(begin, begin, n, n), Eigen::ComputeFullU);
        const Eigen::VectorXd inverted = svd.singularValues().unaryExpr(
            [&](double value) { return value > moment_cut_off * largest ? 1.0 / value : 0.0; });
        const MatrixXd& vectors = svd.matrixU();
        const MatrixXd block_inverse =
            (vectors * inverted.asDiagonal()).lazyProduct(vectors.transpose());
        result.rank += static_cast<int>((inverted.array() > 0.0).count());
        if (result.rank == 0) return std::nullopt;
        const MatrixXd basis = T.middleCols(begin, n), scaled = basis.lazyProduct(block_inverse);
        result.inverse += scaled.lazyProduct(basis.transpose());
        const MatrixXd across = schur.block(begin, end, n, rest);
        const MatrixXd solved = block_inverse.lazyProduct(across);
        schur.bottomRightCorner(rest, rest) -= across.transpose().lazyProduct(solved);
        T.rightCols(rest) -= basis.lazyProduct(solved);
        begin = end;
    }
    result.condition = one_norm(M) * one_norm(result.inverse);
    return result;
}

}  // namespace plumbline
