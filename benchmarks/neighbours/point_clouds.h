#pragma once

#include "solver/foundation/types.h"

#include <string>
#include <vector>

namespace benchmarks {

/// Points in the unit square or cube and a radius that suits them.
template <int Dim> struct PointCloud {
    std::string name;
    plumbline::Points<Dim> points;
    double radius;
};

/// jittered (a lattice with 20 % jitter, r = 2 spacings), uniform (random, the same r), clustered
/// (contrast 100), two_densities (half of the points in a thousandth of the volume, r for that half),
/// graded (1 : 1000), planar, line. All but the first two and the fourth have some 30 neighbours.
std::vector<std::string> cloud_names();

/// About `count` points in random order, the same for the same seed.
/// Throws InvalidInput, naming the clouds there are, if there is none of that name.
template <int Dim>
PointCloud<Dim> make_cloud(const std::string& name, plumbline::Index count, std::uint64_t seed = 1);

/// The median, over a sample, of the distance to the neighbour of that number.
template <int Dim>
double radius_with_neighbours(const plumbline::Points<Dim>& points, std::size_t neighbours);

}  // namespace benchmarks
