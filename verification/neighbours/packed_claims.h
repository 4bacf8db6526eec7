#pragma once

#include "verification/framework/claim.h"
#include "verification/neighbours/clouds.h"
#include "verification/neighbours/packed_searches.h"
#include "verification/neighbours/searches.h"

namespace verification {

/// Adds up what wrong(cloud, points) returns for the points of all clouds in the precision Real.
template <class Real, int Dim, class Wrong> double over_clouds(plumbline::Index n, Wrong wrong) {
    double all = 0.0;
    for (const Cloud<Dim>& cloud : hard_clouds<Dim>(n))
        all += static_cast<double>(wrong(cloud, in_precision<Real, Dim>(cloud.points)));
    return all;
}

/// Wrong pairs of Search::pack in open space over all clouds, against brute force in its precision.
template <class Search, class Real, int Dim> double wrong_packed(double radius_factor) {
    return over_clouds<Real, Dim>(700, [&](const auto& cloud, const auto& points) {
        plumbline::BruteForce<Dim, plumbline::OpenSpace<Dim>, Real> oracle;
        Search search;
        oracle.build(points, cloud.radius);
        search.build(points, cloud.radius * radius_factor);
        plumbline::PackedLists lists;
        search.pack(lists);
        return wrong_pairs(ascending(lists), oracle.query(points));
    });
}

/// Pairs that Search::pack_pairs does not list, lists twice, or should not list. A mistake to be caught:
/// all neighbours are listed, so each pair twice.
template <class Search, class Space> double wrong_halves(const Space& space, bool both_ways) {
    return over_clouds<double, 2>(600, [&](const auto& cloud, auto points) {
        if constexpr (Space::is_periodic)
            for (auto& x : points) x = space.wrap(x);
        plumbline::BruteForce<2, Space> oracle(space);
        Search search(space);
        oracle.build(points, cloud.radius);
        search.build(points, cloud.radius);
        plumbline::PackedLists halves;
        if (both_ways)
            search.pack(halves);
        else
            search.pack_pairs(halves);
        return wrong_pairs(completed(halves), oracle.query(points));
    });
}

/// Distances computed for each neighbour found, with radii that follow a density graded 1 : contrast, as
/// in adaptive SPH: about 30 neighbours everywhere.
template <class Search> double distances_per_neighbour(double contrast) {
    using namespace plumbline;
    constexpr Index n = 20000;
    const Points<3> points = graded(unit_box<3>(), n, contrast);
    const double growth = std::log(contrast);
    std::vector<double> radii;
    for (const Vec<3>& x : points)
        radii.push_back(radius_for<3>(
            30.0, growth == 0.0 ? n : n * growth / (contrast - 1.0) * std::exp(growth * x[0])));
    Search search;
    search.build(points, *std::ranges::max_element(radii));
    PackedLists lists;
    search.pack(radii, lists);
    return static_cast<double>(search.distances(radii)) / static_cast<double>(lists.pairs());
}
template <class Search> double distances_over_those_at_even_density() {
    return distances_per_neighbour<Search>(1000.0) / distances_per_neighbour<Search>(1.0);
}

inline Bound decided_alike() {
    return at_most(0.0, "decided by the same floating-point expression as brute force");
}

}  // namespace verification
