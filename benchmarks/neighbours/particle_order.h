#pragma once

#include "benchmarks/neighbours/point_clouds.h"

namespace benchmarks {

/// as_given, shuffled, by_cell (of the edge of the radius, row by row), morton, hilbert.
std::vector<std::string> order_names();

/// Brings the points, and their radii, into that order; `seed` is of the shuffling.
/// Throws InvalidInput, naming the orders there are, if there is none of that name.
template <int Dim>
void reorder(PointCloud<Dim>& cloud, const std::string& order, std::uint64_t seed = 1);

}  // namespace benchmarks
