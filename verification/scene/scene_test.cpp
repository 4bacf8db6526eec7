#include "solver/scene/scene.h"

#include "solver/fluid/gravity.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/poly6.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/symplectic_euler.h"

#include <catch2/catch.hpp>

namespace scene_test {
namespace {
using namespace plumbline;

using Start = Given<Positions<2>, Velocities<2>, Masses>;

auto falling() { return Scene{Start{}, Gravity<2>{{0, -9.81}}, SymplecticEuler<2>{}}; }
auto weighed(double h) {
    return Scene{Start{}, FindNeighbours<2, HashGrid<2>>{h}, SphDensity<Poly6<2>>{Poly6<2>(h)},
                 Gravity<2>{{0, -9.81}}, SymplecticEuler<2>{}};
}
auto two_particles(auto scene) {
    scene.template get<Positions<2>>().assign({{0, 0}, {0.1, 0}});
    scene.template get<Velocities<2>>().assign(2, Vec<2>::Zero());
    scene.template get<Masses>().assign(2, 1.0);
    return scene;
}

TEST_CASE("a scene stores what its passes write, and nothing else") {
    STATIC_REQUIRE(decltype(weighed(1))::stores<Density>);
    STATIC_REQUIRE(!decltype(falling())::stores<Density>);
    STATIC_REQUIRE(!decltype(falling())::stores<Neighbourhood<2>>);
    STATIC_REQUIRE(sizeof(decltype(falling())) < sizeof(decltype(weighed(1))));
}

TEST_CASE("quantities that nobody gives have one zero for each particle") {
    auto scene = two_particles(weighed(0.5));
    scene.step(0.0);
    CHECK(scene.get<Density>().size() == 2);
    CHECK(scene.get<Accelerations<2>>() == std::vector<Vec<2>>(2, Vec<2>::Zero()));
}

TEST_CASE("a particle alone weighs itself") {
    auto scene = weighed(0.5);
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(1, Vec<2>::Zero());
    scene.get<Masses>().assign(1, 2.0);
    scene.step(1e-3);
    CHECK(scene.get<Density>()[0] == 2.0 * Poly6<2>(0.5).value(0.0));
}

TEST_CASE("a step of no time moves nothing") {
    auto scene = two_particles(falling());
    scene.step(0.0);
    CHECK(scene.get<Positions<2>>()[1] == Vec<2>(0.1, 0));
    CHECK(scene.get<Velocities<2>>()[1] == Vec<2>::Zero());
}

TEST_CASE("a scene refuses what cannot be stepped") {
    auto scene = two_particles(falling());
    CHECK_THROWS_AS(scene.step(-1e-3), InvalidInput);
    CHECK_THROWS_AS(scene.step(NAN), InvalidInput);
    CHECK_THROWS_AS(scene.step(HUGE_VAL), InvalidInput);
    scene.get<Masses>().pop_back();
    CHECK_THROWS_WITH(scene.step(1e-3),
                      Catch::Contains("expected 2 masses") && Catch::Contains("found 1"));
}

TEST_CASE("a scene of no particles can be stepped") {
    auto scene = weighed(0.5);
    CHECK_NOTHROW(scene.step(1e-3));
}
}  // namespace
}  // namespace scene_test
