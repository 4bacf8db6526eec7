#pragma once

#include "solver/particles/uniform_random.h"

#include <algorithm>

namespace plumbline {

struct Clusters {
    int number = 8;
    double radius = 0.0;    // [m]
    double contrast = 100;  // number density inside / outside
};

/// The centres of the clusters of `clustered` with the same box, number and seed.
template <int Dim>
Points<Dim> cluster_centres(const Box<Dim>& box, int number, std::uint64_t seed) {
    return uniform_random(box, require_count(number), seed);
}

/// `count` random points whose number density is `contrast` times higher within `radius` of any of
/// the cluster centres than elsewhere, and constant in both parts. The same points for the same
/// seed.
/// Throws InvalidInput unless contrast ≥ 1, radius > 0, number ≥ 1, both finite; for a box without
/// extent or no points.
template <int Dim>
Points<Dim> clustered(const Box<Dim>& box, Index count, const Clusters& clusters,
                      std::uint64_t seed) {
    require_positive(clusters.radius, "cluster radius");
    if (!(clusters.contrast >= 1.0) || !std::isfinite(clusters.contrast))
        throw InvalidInput("contrast: expected a finite number >= 1, found " +
                           std::to_string(clusters.contrast));
    require_count(count);
    const Points<Dim> centres = cluster_centres(box, clusters.number, seed);
    const auto in_cluster = [&](const Vec<Dim>& x) {
        return std::ranges::any_of(centres, [&](const Vec<Dim>& c) {
            return (x - c).squaredNorm() < clusters.radius * clusters.radius;
        });
    };
    Random random(seed + 1);
    Points<Dim> points;
    while (points.size() < count) {
        const Vec<Dim> x = random_point(box, random);
        const bool taken = random.uniform() * clusters.contrast < 1.0;
        if (taken || in_cluster(x)) points.push_back(x);
    }
    return points;
}

}  // namespace plumbline
