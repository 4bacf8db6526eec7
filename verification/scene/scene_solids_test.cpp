#include "solver/scene/scene_solids.h"

#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace scene_solids_test {
namespace {
using namespace plumbline;
using namespace verification;

SceneFile with_table(const std::string& table, int dim = 2) {
    return SceneFile::parse("s.toml", dam_break_scene(dim, "delta_sph", 1.0) + table);
}
std::string complaint(const std::string& table, int dim = 2) {
    try {
        with_table(table, dim);
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return "none";
}

TEST_CASE("constraints are solids or holes, and have a surface") {
    const SceneFile scene = with_table(
        "[[constraint]]\nshape = \"sphere\"\ncentre = [0.8, 0.1]\nradius = 0.1\nrestitution = 0.5\n"
        "[[constraint]]\nshape = \"box\"\nlow = [0, 0]\nhigh = [1, 2]\nstay = \"inside\"\n"
        "friction = 0.2\nvelocity = [0, 1]\n");
    REQUIRE(scene.constraints.size() == 2);
    CHECK(scene.constraints[0].shape.form == SolidShape::Form::sphere);
    CHECK(scene.constraints[0].shape.radius == 0.1);
    CHECK_FALSE(scene.constraints[0].hollow);
    CHECK(scene.constraints[0].restitution == 0.5);
    CHECK(scene.constraints[1].hollow);
    CHECK(scene.constraints[1].friction == 0.2);
    CHECK(scene.constraints[1].velocity == Vec<3>(0, 1, 0));
}

TEST_CASE("constraints without sense are refused") {
    CHECK(complaint("[[constraint]]\nshape = \"plane\"\npoint = [0, 0]\nnormal = [0, 0]\n")
              .find("a vector that is not zero") != std::string::npos);
    CHECK(complaint("[[constraint]]\nshape = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\nstay = "
                    "\"inside\"\n")
              .find("without a shape that has an inside") != std::string::npos);
    CHECK(complaint("[[constraint]]\nshape = \"mesh\"\nfile = \"a.obj\"\n")
              .find("no mesh in the plane") != std::string::npos);
    CHECK(complaint("[[constraint]]\nshape = \"mesh\"\nfile = \"a.obj\"\n", 3) == "none");
    CHECK(complaint("[[constraint]]\nshape = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"
                    "restitution = 1.5\n")
              .find("a number from 0 to 1, found 1.5") != std::string::npos);
    CHECK(complaint("[[constraint]]\nshape = \"sphere\"\ncentre = [0, 0]\nradius = 0\n")
              .find("a number > 0, found 0") != std::string::npos);
}

const std::string box = "[[body]]\nshape = \"box\"\nlow = [0.7, 0.1]\nhigh = [0.8, 0.2]\n";

TEST_CASE("bodies are free or fixed, and have a name") {
    const SceneFile scene = with_table(box + "density = 500\nspin = 2\n" + box +
                                       "fixed = true\nvelocity = [1, 0]\nname = \"piston\"\n"
                                       "[contact]\nrestitution = 0.5\n");
    REQUIRE(scene.bodies.size() == 2);
    CHECK(scene.bodies[0].name == "body_1");
    CHECK(scene.bodies[0].density == 500.0);
    CHECK(scene.bodies[0].spin == Vec<3>(0, 0, 2));
    CHECK_FALSE(scene.bodies[0].fixed);
    CHECK(scene.bodies[1].name == "piston");
    CHECK(scene.bodies[1].fixed);
    CHECK(scene.body_restitution == 0.5);
}

TEST_CASE("bodies without sense are refused") {
    const auto says = [](const std::string& table, const std::string& what, int dim = 2) {
        const std::string found = complaint(table, dim);
        INFO(found);
        CHECK(found.find(what) != std::string::npos);
    };
    says(box, "expected a key \"density\"");
    says(box + "density = 500\nmass = 1\n", "without leaving out \"density\"");
    says(box + "fixed = true\ndensity = 1\n", "without a body that is free");
    says(box + "density = 500\nname = \"a,b\"\n", "a name without commas");
    says(box + "density = 500\nname = \"a\"\n" + box + "density = 500\nname = \"a\"\n",
         "\"a\" twice");
    says("[[body]]\nshape = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\ndensity = 1\n",
         "a shape that ends somewhere");
    says(box + "density = 500\nspin = [0, 0, 1]\n", "expected a finite number");
}

TEST_CASE("emitters need a domain and room for a particle") {
    const std::string emitter =
        "[[emitter]]\ncentre = [0.7, 0.3]\ndirection = [0, -2]\nspeed = 1\nuntil = 2\n";
    const std::string domain = "[domain]\nlow = [-1, -1]\nhigh = [2, 2]\n";
    const SceneFile scene = with_table(emitter + "radius = 0.1\n" + domain);
    REQUIRE(scene.emitters.size() == 1);
    CHECK(scene.emitters[0].direction == Vec<3>(0, -1, 0));
    CHECK(scene.emitters[0].until == 2.0);
    CHECK(complaint(emitter + "radius = 0.1\n").find("[domain]") != std::string::npos);
    CHECK(complaint(emitter + "radius = 0.001\n" + domain).find("room for a particle") !=
          std::string::npos);
    CHECK(
        with_table("[[outflow]]\nshape = \"box\"\nlow = [1, 0]\nhigh = [2, 1]\n").outflows.size() ==
        1);
}
}  // namespace
}  // namespace scene_solids_test
