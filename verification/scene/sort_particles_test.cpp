#include "solver/scene/sort_particles.h"

#include "solver/neighbours/cell_grid.h"
#include "solver/particles/jittered.h"

#include <catch2/catch.hpp>

namespace sort_particles_test {
namespace {
using namespace plumbline;

struct Number : Each<int> {
    static constexpr std::string_view name = "numbers";
};
struct OfGhosts : Each<int, Ghosts> {
    static constexpr std::string_view name = "numbers of ghosts";
};

TEST_CASE("sorting moves all quantities of a particle together, and those of ghosts not at all") {
    const Box<2> box{Vec<2>::Zero(), Vec<2>::Constant(10.0)};
    const auto points = jittered<2>(box, 1.0, 0.4, 1);
    Scene scene{Given<Positions<2>, Number>{}, Given<OfGhosts>{}};
    for (std::size_t i = points.size(); i-- > 0;) {
        scene.get<Positions<2>>().push_back(points[i]);
        scene.get<Number>().push_back(static_cast<int>(i));
        scene.get<OfGhosts>().push_back(static_cast<int>(i));
    }
    const std::vector<int> ghosts = scene.get<OfGhosts>();
    sort_particles<2>(scene, 2.0);
    const auto& x = scene.get<Positions<2>>();
    REQUIRE(x.size() == points.size());
    for (std::size_t k = 0; k < x.size(); ++k)
        CHECK(x[k] == points[static_cast<std::size_t>(scene.get<Number>()[k])]);
    CHECK(scene.get<OfGhosts>() == ghosts);

    CellGrid<2> grid;
    grid.build(x, 2.0);
    CHECK(std::ranges::is_sorted(grid.point_order()));
}

TEST_CASE("a scene of no particles can be sorted") {
    Scene scene{Given<Positions<2>, Number>{}};
    CHECK_NOTHROW(sort_particles<2>(scene, 1.0));
}
}  // namespace
}  // namespace sort_particles_test
