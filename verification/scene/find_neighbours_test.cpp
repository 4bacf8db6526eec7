#include "solver/scene/find_neighbours.h"

#include "solver/neighbours/brute_force.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/scene.h"

#include <catch2/catch.hpp>

namespace find_neighbours_test {
namespace {
using namespace plumbline;

TEST_CASE("the neighbours are those of the search") {
    Scene scene{Given<Positions<2>>{}, FindNeighbours<2, CellGrid<2>>{1.0}};
    scene.get<Positions<2>>().assign({{0, 0}, {0.9, 0}, {1.8, 0}});
    scene.step(0.0);
    const auto& lists = scene.get<Neighbourhood<2>>().lists;
    CHECK(lists.indices == std::vector<Index>{0, 1, 0, 1, 2, 1, 2});
}

TEST_CASE("in a box without end, particles that left come back, and see each other") {
    using Box = PeriodicBox<2>;
    const Box box({0, 0}, {4, 4});
    using Search = BruteForce<2, Box>;
    Scene scene{Given<Positions<2>>{}, WrapIntoBox<2>{box},
                FindNeighbours<2, Search>{1.0, Search(box)}};
    scene.get<Positions<2>>().assign({{4.2, 1}, {3.8, 1}});
    scene.step(0.0);
    CHECK(scene.get<Positions<2>>()[0].x() == Approx(0.2));
    CHECK(scene.get<Neighbourhood<2, Box>>().lists.of(0).size() == 2);
}

TEST_CASE("ghosts are found near particles") {
    Scene scene{Given<Positions<2>, GhostPositions<2>>{}, FindGhosts<2, CellGrid<2>>{1.0}};
    scene.get<Positions<2>>().assign({{0, 0}, {5, 0}});
    scene.get<GhostPositions<2>>().assign({{0, -0.5}, {0.5, -0.5}, {0, -2}});
    scene.step(0.0);
    const auto& lists = scene.get<GhostNeighbourhood<2>>().lists;
    CHECK(lists.of(0).size() == 2);
    CHECK(lists.of(1).empty());
}
}  // namespace
}  // namespace find_neighbours_test
