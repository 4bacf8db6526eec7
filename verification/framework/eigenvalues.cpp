#include "verification/framework/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace verification {

template <int N> plumbline::Vec<N> eigenvalues(const plumbline::Mat<N>& symmetric) {
    return Eigen::SelfAdjointEigenSolver<plumbline::Mat<N>>(symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues();
}
template plumbline::Vec<2> eigenvalues<2>(const plumbline::Mat<2>&);
template plumbline::Vec<3> eigenvalues<3>(const plumbline::Mat<3>&);
template plumbline::Vec<4> eigenvalues<4>(const plumbline::Mat<4>&);

double spectral_radius(const Eigen::MatrixXd& square) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(square, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace verification
