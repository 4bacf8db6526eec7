#pragma once

#include "solver/foundation/types.h"

#include <string>
#include <vector>

namespace benchmarks {

/// Points and the radius within which their neighbours are asked.
template <int Dim> struct PointCloud {
    std::string name;
    plumbline::Points<Dim> points;
    double radius;                   // for all; with `radii`, a size typical of them
    std::vector<double> radii = {};  // of each point; empty: the same for all
    std::string order = "as_given";  // of the points, see particle_order.h
};

/// Which points, how many, and the ratio of their highest to their lowest number density where a
/// cloud has two (clustered, graded, two_densities).
struct CloudRequest {
    std::string name = "jittered";
    plumbline::Index count = 100000;
    double contrast = 1000.0;
    std::uint64_t seed = 1;
};

/// In the unit square or cube, if nothing else is said:
/// - jittered: a square (cubic) lattice with 20 % jitter; uniform: random;
/// - clustered: random, denser within 20 balls of radius 0.05; gaussian: 50 normal clusters with
///   standard deviations from 0.005 to 0.05;
/// - graded: the density grows exponentially along x; two_densities: one half fills the box, the other
///   a box around the centre;
/// - planar, line: random in the first Dim - 1 axes, in the first one;
/// - dam_break: water under Ritter's profile and the walls of its tank, see dam_break.h.
std::vector<std::string> cloud_names();

/// About `count` points, the same for the same request, with the usual radius: two spacings of the
/// lattice (of the dense part, for two_densities), of a lattice of as many points for uniform, else
/// that within which the median point has 30 neighbours.
/// Throws InvalidInput, naming the clouds there are, if there is none of that name.
template <int Dim> PointCloud<Dim> make_cloud(const CloudRequest& request);

/// Whether make_cloud depends on the contrast.
bool has_contrast(const std::string& cloud);

/// The median, over a sample, of the distance to the neighbour of that number.
template <int Dim>
double radius_with_neighbours(const plumbline::Points<Dim>& points, std::size_t neighbours);

/// The number of neighbours at the usual radius, which is called two spacings in every cloud.
inline constexpr std::size_t usual_neighbours = 30;
inline constexpr double usual_spacings = 2.0;

}  // namespace benchmarks
