#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace plumbline {

/// A particle; 4 bytes keep neighbour lists small.
using Index = std::uint32_t;

/// A position [m], velocity [m/s], gradient [1/m] … in Dim = 1, 2 or 3 dimensions: a column.
template <int Dim> using Vec = Eigen::Matrix<double, Dim, 1>;

/// A linear map of such vectors, Dim × Dim.
template <int Dim> using Mat = Eigen::Matrix<double, Dim, Dim>;

/// One vector per particle, in the order of their indices.
template <int Dim> using Points = std::vector<Vec<Dim>>;

}  // namespace plumbline
