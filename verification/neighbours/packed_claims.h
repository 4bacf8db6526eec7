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

inline Bound decided_alike() {
    return at_most(0.0, "decided by the same floating-point expression as brute force");
}

}  // namespace verification
