#pragma once

#include "solver/foundation/types.h"

#include <vector>

namespace benchmarks {

/// The distance of each point to its neighbour of that number (or to its farthest): radii that follow
/// the density. 1 where all of these neighbours coincide with the point.
template <int Dim>
std::vector<double> local_radii(const plumbline::Points<Dim>& points, std::size_t neighbours);

}  // namespace benchmarks
