#include "solver/neighbours/grouped_search.h"

#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/leaf_tree.h"
#include "solver/neighbours/level_grid.h"
#include "solver/particles/uniform_random.h"

#include <catch2/catch.hpp>

#include <limits>

namespace grouped_search_test {

using namespace plumbline;

TEMPLATE_TEST_CASE("grouped searches: no points, one point", "", CellGrid<3>, LeafTree<3>,
                   LevelGrid<3>, (CellGrid<3, PeriodicBox<3>>), (LeafTree<3, PeriodicBox<3>>),
                   (LevelGrid<3, PeriodicBox<3>>)) {
    using Space = std::decay_t<decltype(std::declval<TestType>().space())>;
    const auto search = [](const Points<3>& points) {
        TestType made = [] {
            if constexpr (Space::is_periodic)
                return TestType(Space(Vec<3>::Zero(), Vec<3>::Ones()));
            else
                return TestType();
        }();
        made.build(points, 0.1);
        return made;
    };
    PackedLists lists;
    std::vector<Index> counts{7};
    search({}).pack(lists);
    CHECK(lists.size() == 0);
    search({}).count(counts);
    CHECK(counts.empty());
    const auto one = search({Vec<3>(0.5, 0.5, 0.5)});
    one.pack(lists);
    CHECK(ascending(lists) == NeighbourLists{{0, 1}, {0}});
    one.pack_pairs(lists);
    CHECK(ascending(lists) == NeighbourLists{{0, 0}, {}});
    one.count(counts);
    CHECK(counts == std::vector<Index>{1});
}

TEMPLATE_TEST_CASE("grouped searches: bad radii are refused", "", CellGrid<2>, LeafTree<2>,
                   LevelGrid<2>) {
    const Points<2> points = uniform_random(unit_box<2>(), 20, 1);
    TestType search;
    search.build(points, 0.1);
    PackedLists lists;
    for (const double radius : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e200}) {
        CHECK_THROWS_AS(search.pack(radius, lists), InvalidInput);
        CHECK_THROWS_AS(search.pack(std::vector<double>(20, radius), lists), InvalidInput);
    }
    CHECK_THROWS_AS(search.pack(std::vector<double>(19, 0.1), lists), InvalidInput);
}

TEMPLATE_TEST_CASE("grouped searches: lists are used again, for fewer points and for more", "",
                   CellGrid<3>, LeafTree<3>, LevelGrid<3>) {
    PackedLists lists;
    for (const Index n : {3000u, 10u, 5000u, 3000u}) {
        const Points<3> points = uniform_random(unit_box<3>(), n, n);
        TestType search;
        search.build(points, 0.1);
        search.pack(lists);
        CHECK(ascending(lists) == search.query(points));
        PackedLists elsewhere;
        const Points<3> queries = uniform_random(unit_box<3>(), 100, 99);
        search.query(queries, elsewhere);
        CHECK(ascending(elsewhere) == search.query(queries));
    }
}

}  // namespace grouped_search_test
