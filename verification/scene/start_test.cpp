#include "solver/scene/start.h"

#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace start_test {
namespace {
using namespace plumbline;
using namespace verification;

SceneFile scene(const std::string& from = "", const std::string& to = "", int dim = 2) {
    return SceneFile::parse("s.toml", with(dam_break_scene(dim, "delta_sph", 1.0), from, to));
}

TEST_CASE("blocks hold as many particles as their volume asks for, with the mass of it") {
    for (const int dim : {2, 3}) {
        const SceneFile file = scene("", "", dim);
        const double mass = dim == 2 ? 1000 * 0.6 * 0.3 : 1000 * 0.6 * 0.3 * 0.3;
        double sum = 0.0;
        if (dim == 2)
            for (const double m : start_of<2>(file).m) sum += m;
        else
            for (const double m : start_of<3>(file).m) sum += m;
        CHECK(sum == Approx(mass));
    }
}

TEST_CASE("a tank has three layers of ghosts outside, none inside, and none at an open side") {
    const Start<2> start = start_of<2>(scene());
    // 50 + 2 * 3 columns of 3 below, 30 rows of 3 on either side.
    CHECK(start.ghosts.size() == 56 * 3 + 2 * 3 * 30);
    for (const Vec<2>& x : start.ghosts) {
        const bool inside = x[0] > 0 && x[0] < 1 && x[1] > 0;
        CHECK_FALSE(inside);
        CHECK(x[1] < 0.6);
    }
    CHECK(start.ghost_masses.size() == start.ghosts.size());
    CHECK(start.ghost_velocities.size() == start.ghosts.size());
}

TEST_CASE("a plane has ghosts behind it, as far as the domain reaches") {
    const std::string plane =
        "[domain]\nlow = [-0.1, -0.1]\nhigh = [1, 1]\n[[wall]]\nshape = \"plane\"\n"
        "point = [0, 0]\nnormal = [0, 2]\nvelocity = [3, 0]\n[time]";
    const std::string text = with(dam_break_scene(2, "delta_sph", 1.0), "[time]", plane);
    const std::size_t tank = text.find("[[wall]]\nshape = \"tank\""), end = text.find("[domain]");
    const Start<2> start =
        start_of<2>(SceneFile::parse("s.toml", text.substr(0, tank) + text.substr(end)));
    REQUIRE_FALSE(start.ghosts.empty());
    for (const Vec<2>& x : start.ghosts) {
        CHECK(x[1] < 0.0);
        CHECK(x[1] > -0.06);
    }
    CHECK(start.ghost_velocities[0] == Vec<2>(3, 0));
}

TEST_CASE("a hydrostatic block has the pressure of its depth") {
    const SceneFile file = scene("shape = \"box\"", "shape = \"box\"\nhydrostatic = true");
    const Start<2> start = start_of<2>(file);
    for (std::size_t i = 0; i < start.x.size(); ++i)
        CHECK(tait_of(file).pressure(start.rho[i]) ==
              Approx(1000 * 9.81 * (0.3 - start.x[i][1])).margin(1e-6));
}

TEST_CASE("spheres, jittered and hexagonal samplings") {
    const SceneFile sphere = scene("shape = \"box\"\nlow = [0, 0]\nhigh = [0.6, 0.3]",
                                   "shape = \"sphere\"\ncentre = [0.3, 0.2]\nradius = 0.15\n"
                                   "stretching = [-2, 2]");
    const Start<2> drop = start_of<2>(sphere);
    for (std::size_t i = 0; i < drop.x.size(); ++i) {
        const Vec<2> from = drop.x[i] - Vec<2>(0.3, 0.2);
        CHECK(from.norm() < 0.15);
        CHECK((drop.v[i] - Vec<2>(-2 * from[0], 2 * from[1])).norm() < 1e-15);
    }
    CHECK(start_of<2>(
              scene("shape = \"box\"", "shape = \"box\"\nsampling = \"jittered\"\njitter = 0.2"))
              .x.size() == 450);
    CHECK(start_of<2>(scene("shape = \"box\"", "shape = \"box\"\nsampling = \"hexagonal\""))
              .x.size() > 450);
}

TEST_CASE("blocks that overlap, are empty, or tanks that do not fit the spacing are refused") {
    CHECK_THROWS_WITH(
        start_of<2>(scene("[[wall]]",
                          "[[block]]\nshape = \"box\"\nlow = [0, 0]\nhigh = [0.1, 0.1]\n[[wall]]")),
        Catch::Contains("do not overlap"));
    CHECK_THROWS_WITH(
        start_of<2>(scene("low = [0, 0]\nhigh = [0.6, 0.3]", "low = [-0.1, 0]\nhigh = [0.6, 0.3]")),
        Catch::Contains("nor reach into walls"));
    CHECK_THROWS_WITH(start_of<2>(scene("high = [0.6, 0.3]", "high = [0.6, 0.01]")),
                      Catch::Contains("s.toml:14:1: spacing: expected cells that fit"));
    CHECK_THROWS_WITH(start_of<2>(scene("high = [1, 0.6]", "high = [1.01, 0.6]")),
                      Catch::Contains("multiples of the spacing 0.02, found 1.01"));
}
}  // namespace
}  // namespace start_test
