#include "verification/neighbours/searches.h"

#include <catch2/catch.hpp>

#include <limits>

namespace queries_test {
namespace {
using namespace plumbline;
using verification::for_each_search;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <int Dim> Points<Dim> first_points(std::size_t n) {
    Points<Dim> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(Vec<Dim>::Constant(0.25 * double(i)));
    return points;
}

template <class S, int Dim> constexpr bool is_search = VariableRadiusSearch<S, Dim>;
static_assert(is_search<BruteForce<3>, 3> && is_search<KdTree<2>, 2> && is_search<HashGrid<1>, 1>);
static_assert(is_search<CellGrid<3, PeriodicBox<3>>, 3>);
}  // namespace

TEMPLATE_TEST_CASE_SIG("searches: no points, one point, no queries", "", ((int Dim), Dim), 1, 2,
                       3) {
    for_each_search<Dim>([](auto search) {
        INFO(search.name);
        search.build(Points<Dim>{}, 1.0);
        CHECK(search.query(Points<Dim>{}) == NeighbourLists{{0}, {}});
        CHECK(search.query(first_points<Dim>(2)) == NeighbourLists{{0, 0, 0}, {}});
        search.build(first_points<Dim>(1), 1.0);
        CHECK(search.query(first_points<Dim>(1)) == NeighbourLists{{0, 1}, {0}});
        CHECK(search.query(Points<Dim>{}) == NeighbourLists{{0}, {}});
    });
}

TEMPLATE_TEST_CASE_SIG("searches: a point at exactly the radius is no neighbour", "",
                       ((int Dim), Dim), 1, 2, 3) {
    Points<Dim> points(3, Vec<Dim>::Zero());
    points[1][0] = -1.0;
    points[2][0] = 1.0;
    for_each_search<Dim>([&](auto search) {
        INFO(search.name);
        search.build(points, 1.0);
        CHECK(search.query(points) == NeighbourLists{{0, 1, 2, 3}, {0, 1, 2}});
        const double wider = std::nextafter(1.0, 2.0);
        CHECK(search.query(points, std::vector(3, wider)) ==
              NeighbourLists{{0, 3, 5, 7}, {0, 1, 2, 0, 1, 0, 2}});
    });
}

TEMPLATE_TEST_CASE_SIG("searches: bad input is refused", "", ((int Dim), Dim), 1, 2, 3) {
    const Points<Dim> good = first_points<Dim>(5);
    for_each_search<Dim>([&](auto search) {
        INFO(search.name);
        for (const double radius : {0.0, -1.0, not_a_number, infinity, 1e-160, 1e160})
            CHECK_THROWS_AS(search.build(good, radius), InvalidInput);
        for (const double coordinate : {not_a_number, infinity, -infinity, 1e160}) {
            Points<Dim> bad = good;
            bad[3][Dim - 1] = coordinate;
            CHECK_THROWS_AS(search.build(bad, 1.0), InvalidInput);
            search.build(good, 1.0);
            CHECK_THROWS_AS(search.query(bad), InvalidInput);
        }
        CHECK_THROWS_AS(search.query(good, std::vector{1.0}), InvalidInput);
        CHECK_THROWS_AS(search.query(good, std::vector(5, -1.0)), InvalidInput);
    });
}

TEST_CASE("searches: a periodic box refuses points outside and radii of half its edge") {
    const PeriodicBox<2> box({0, 0}, {1, 2});
    for_each_search<2>(box, [](auto search) {
        INFO(search.name);
        CHECK_THROWS_AS(search.build(first_points<2>(6), 0.3), InvalidInput);
        CHECK_THROWS_AS(search.build(first_points<2>(5), 0.5), InvalidInput);
        search.build(first_points<2>(5), 0.3);
        CHECK_THROWS_AS(search.query(first_points<2>(5), std::vector(5, 0.5)), InvalidInput);
    });
    CHECK_THROWS_AS(PeriodicBox<2>({0, 0}, {1, 0}), InvalidInput);
    CHECK(box.wrap({-0.25, 4.5}) == Vec<2>(0.75, 0.5));
}

}  // namespace queries_test
