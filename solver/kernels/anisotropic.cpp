#include "solver/kernels/anisotropic.h"

#include <Eigen/Eigenvalues>

namespace plumbline {

template <int Dim> double norm_of_inverse(const Mat<Dim>& g) { return g.inverse().operatorNorm(); }
template double norm_of_inverse<1>(const Mat<1>&);
template double norm_of_inverse<2>(const Mat<2>&);
template double norm_of_inverse<3>(const Mat<3>&);

}  // namespace plumbline
