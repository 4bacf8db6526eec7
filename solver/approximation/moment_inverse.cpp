#include "solver/approximation/moment_inverse.h"

#include <Eigen/Eigenvalues>
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
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(schur.block(begin, begin, n, n));
        const Eigen::VectorXd inverted = eigen.eigenvalues().unaryExpr(
            [&](double value) { return value > moment_cut_off * largest ? 1.0 / value : 0.0; });
        const MatrixXd& vectors = eigen.eigenvectors();
        const MatrixXd block_inverse = vectors * inverted.asDiagonal() * vectors.transpose();
        result.rank += static_cast<int>((inverted.array() > 0.0).count());
        if (result.rank == 0) return std::nullopt;
        result.inverse +=
            T.middleCols(begin, n) * block_inverse * T.middleCols(begin, n).transpose();
        const MatrixXd across = schur.block(begin, end, n, rest), solved = block_inverse * across;
        schur.bottomRightCorner(rest, rest) -= across.transpose() * solved;
        T.rightCols(rest) -= T.middleCols(begin, n) * solved;
        begin = end;
    }
    result.condition = one_norm(M) * one_norm(result.inverse);
    return result;
}

}  // namespace plumbline
