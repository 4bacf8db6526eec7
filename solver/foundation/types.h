#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace plumbline {

using Index = std::uint32_t;  // a particle; 4 bytes keep neighbour lists small
template <int Dim> using Vec = Eigen::Matrix<double, Dim, 1>;
template <int Dim> using Mat = Eigen::Matrix<double, Dim, Dim>;
template <int Dim> using Points = std::vector<Vec<Dim>>;

}  // namespace plumbline
