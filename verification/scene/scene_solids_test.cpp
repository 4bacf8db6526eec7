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
}  // namespace
}  // namespace scene_solids_test
