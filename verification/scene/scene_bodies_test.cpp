#include "solver/scene/scene_bodies.h"

#include "solver/scene/simulation.h"
#include "solver/scene/start.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace scene_bodies_test {
namespace {
using namespace plumbline;
using namespace verification;

SceneFile with_body(const std::string& table, int dim = 2) {
    return SceneFile::parse("s.toml", dam_break_scene(dim, "delta_sph", 1.0) + table);
}
std::string box(const std::string& low, const std::string& high) {
    return "[[body]]\nshape = \"box\"\nlow = " + low + "\nhigh = " + high + "\ndensity = 500\n";
}

TEST_CASE("a box in the fluid takes the room of as many particles as it has cells") {
    const SceneFile scene = with_body(box("[0.2, 0.1]", "[0.4, 0.2]"));
    const Start<2> start = start_of<2>(scene);
    const Start<2> without = start_of<2>(with_body(""));
    CHECK(start.x.size() == without.x.size() - 50);
    CHECK(start.ghosts.size() == without.ghosts.size() + 50);
    CHECK(start.bodies.size() == 1);
    CHECK(start.bodies[0].mass == Approx(500 * 0.2 * 0.1));
    CHECK(start.bodies[0].inertia(0, 0) == Approx(10.0 * (0.04 + 0.01) / 12.0));
    CHECK((start.bodies[0].centre - Vec<2>(0.3, 0.15)).norm() < 1e-15);
    CHECK(start.body_of_ghost.front() == no_body);
    CHECK(start.body_of_ghost.back() == 0);
}

TEST_CASE("ghosts begin with the velocity of their body") {
    const SceneFile scene = with_body(
        "[[body]]\nshape = \"sphere\"\ncentre = [0.8, 0.3, 0.3]\nradius = 0.15\nmass = 3\n"
        "velocity = [1, 0, 0]\nspin = [0, 0, 2]\n",
        3);
    const Start<3> start = start_of<3>(scene);
    const RigidBody<3>& body = start.bodies[0];
    CHECK(body.mass == 3.0);
    CHECK(body.inertia(1, 1) == Approx(0.4 * 3.0 * 0.15 * 0.15));
    const Vec<3> arm = start.ghosts.back() - body.centre;
    CHECK((start.ghost_velocities.back() - Vec<3>(1.0 - 2.0 * arm[1], 2.0 * arm[0], 0.0)).norm() <
          1e-14);
}

TEST_CASE("bodies that cannot be are refused with their place") {
    CHECK_THROWS_WITH(make_simulation(with_body(box("[0.7, 0.1]", "[0.81, 0.2]"))),
                      Catch::StartsWith("s.toml:28:1: expected a box whose edges are multiples"));
    CHECK_THROWS_WITH(make_simulation(with_body(box("[0.7, 0.1]", "[0.8, 0.2]") +
                                                box("[0.76, 0.1]", "[0.9, 0.2]"))),
                      Catch::Contains("do not overlap each other"));
    CHECK_THROWS_WITH(make_simulation(with_body(box("[0.7, -0.02]", "[0.8, 0.2]"))),
                      Catch::Contains("nor reach into walls"));
    CHECK_NOTHROW(
        make_simulation(with_body(box("[0.7, 0]", "[0.8, 0.2]") + box("[0.8, 0]", "[0.9, 0.2]"))));
}
}  // namespace
}  // namespace scene_bodies_test
