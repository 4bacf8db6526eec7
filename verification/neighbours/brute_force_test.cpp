#include "solver/neighbours/brute_force.h"

#include "verification/neighbours/clouds.h"
#include "verification/neighbours/packed_searches.h"
#include "verification/neighbours/searches.h"

#include <catch2/catch.hpp>

namespace brute_force_test {

// Every search against brute force, pair by pair. `plumbline_tests "[long]"` decides more than 1e8 pairs for
// each search; the quick level of the same test is part of every run.

namespace {
using namespace plumbline;
using namespace verification;

/// Checks one search of the precision of its points; returns how many pairs it decided.
template <class Search, class Real, int Dim>
double check(Search search, const Cloud<Dim>& cloud, const std::vector<VecOf<Real, Dim>>& points,
             const NeighbourLists& expected) {
    INFO(search.name << " on " << cloud.name);
    search.build(points, cloud.radius);
    CHECK(wrong_pairs(search.query(points), expected) == 0);
    if constexpr (requires(PackedLists & lists) { search.pack(lists); }) {
        PackedLists lists;
        search.pack(lists);
        CHECK(wrong_pairs(ascending(lists), expected) == 0);
        search.pack_pairs(lists);
        CHECK(wrong_pairs(completed(lists), expected) == 0);
    }
    return static_cast<double>(points.size()) * static_cast<double>(points.size());
}

template <class Real, int Dim, class Space>
NeighbourLists brute_force(const Space& space, const std::vector<VecOf<Real, Dim>>& points,
                           double radius) {
    BruteForce<Dim, Space, Real> oracle(space);
    oracle.build(points, radius);
    return oracle.query(points);
}

/// Returns how many pairs each search decided.
template <int Dim> double check_all(Index n) {
    double decided = 0.0;
    for (const Cloud<Dim>& cloud : hard_clouds<Dim>(n)) {
        const OpenSpace<Dim> open;
        const auto expected = brute_force<double, Dim>(open, cloud.points, cloud.radius);
        for_each_search<Dim>([&](auto search) {
            check<decltype(search), double, Dim>(search, cloud, cloud.points, expected);
        });
        const auto rounded = in_precision<float, Dim>(cloud.points);
        const auto expected_in_single = brute_force<float, Dim>(open, rounded, cloud.radius);
        using Grid = CellGrid<Dim, OpenSpace<Dim>, float>;
        using Tree = LeafTree<Dim, OpenSpace<Dim>, float>;
        using Levels = LevelGrid<Dim, OpenSpace<Dim>, float>;
        check<Grid, float, Dim>(Grid(), cloud, rounded, expected_in_single);
        check<Levels, float, Dim>(Levels(), cloud, rounded, expected_in_single);
        decided += check<Tree, float, Dim>(Tree(), cloud, rounded, expected_in_single);
    }
    return decided;
}
}  // namespace

TEST_CASE("searches: no pair missing, none spurious, quick level") {
    CHECK(check_all<2>(300) + check_all<3>(300) > 2e6);
}
TEST_CASE("searches: no pair missing, none spurious, of 1e8 pairs for each search", "[.long]") {
    CHECK(check_all<3>(3000) > 1e8);
    CHECK(check_all<2>(3000) > 1e8);
}

}  // namespace brute_force_test
