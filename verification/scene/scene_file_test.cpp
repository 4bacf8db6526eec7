#include "solver/scene/scene_file.h"

#include "solver/foundation/errors.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace scene_file_test {
namespace {
using namespace plumbline;
using namespace verification;

const std::string good = dam_break_scene(2, "delta_sph", 1.0);

/// What is said about the scene with `from` replaced by `to`.
std::string complaint(const std::string& from, const std::string& to,
                      const std::string& text = good) {
    const std::string changed = with(text, from, to);
    REQUIRE_FALSE(changed.empty());
    try {
        SceneFile::parse("s.toml", changed);
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return "none";
}

TEST_CASE("a scene file says what is simulated") {
    const SceneFile scene = SceneFile::parse("s.toml", good);
    CHECK(scene.title == "dam break");
    CHECK(scene.dim == 2);
    CHECK(scene.method == Method::delta_sph);
    CHECK(scene.gravity == Vec<3>(0, -9.81, 0));
    CHECK(scene.support == Approx(0.052));
    CHECK(scene.viscosity == ViscosityForm::artificial);
    CHECK(scene.cohesion == 0.0);
    REQUIRE(scene.blocks.size() == 1);
    CHECK(scene.blocks[0].high == Vec<3>(0.6, 0.3, 0));
    REQUIRE(scene.walls.size() == 1);
    CHECK(scene.walls[0].open[1][1]);
    CHECK_FALSE(scene.walls[0].open[1][0]);
    CHECK_FALSE(scene.step.has_value());
    CHECK(scene.scalar_interval == Approx(0.002));
}

TEST_CASE("whole numbers stand for numbers, and keys that are left out have a meaning") {
    const SceneFile scene = SceneFile::parse("s.toml", with(good, "support = 2.6\n", ""));
    CHECK(scene.support == Approx(0.06));
    CHECK(scene.density == 1000.0);
    CHECK(scene.pressure_force == PressureForm::symmetric);
}

TEST_CASE("messages name line, column, and what was expected") {
    CHECK(complaint("dim = 2", "dim = 4") ==
          "s.toml:2:7: expected a whole number from 2 to 3, found 4");
    CHECK(complaint("dim = 2", "dim = 2.0") ==
          "s.toml:2:7: expected a whole number from 2 to 3, found 2");
    CHECK(complaint("spacing = 0.02", "spacing = -0.02") ==
          "s.toml:6:11: expected a number > 0, found -0.02");
    CHECK(complaint("spacing = 0.02", "spacing = nan") ==
          "s.toml:6:11: expected a number > 0, found nan");
    CHECK(complaint("spacing = 0.02", "spacing = \"fine\"") ==
          "s.toml:6:11: expected a number > 0, found \"fine\"");
    CHECK(complaint("spacing = 0.02", "spacing = true") ==
          "s.toml:6:11: expected a number > 0, found true");
    CHECK(complaint("spacing = 0.02\n", "") ==
          "s.toml:5:1: expected a key \"spacing\" in [particles], a number > 0, found none");
    CHECK(complaint("support = 2.6", "suport = 2.6") ==
          "s.toml:7:1: expected one of the keys spacing, support in [particles], found \"suport\"");
    CHECK(complaint("[0, -9.81]", "[0, 0, -9.81]") ==
          "s.toml:4:11: expected a list of 2 numbers, found a list of 3");
    CHECK(complaint("[0, -9.81]", "[0, \"down\"]") ==
          "s.toml:4:15: expected a finite number, found \"down\"");
    CHECK(complaint("\"artificial\"", "\"honey\"") ==
          "s.toml:11:13: expected one of \"none\", \"artificial\", \"brookshaw\", \"monaghan\", "
          "found "
          "\"honey\"");
    CHECK(complaint("title = \"dam break\"", "title = \"dam break")
              .starts_with("s.toml:1:19: expected TOML, found something else"));
}

TEST_CASE("keys that mean nothing beside others are refused") {
    CHECK(complaint("alpha = 0.1", "alpha = 0.1\nmu = 1").find("without viscosity = ") !=
          std::string::npos);
    CHECK(complaint("alpha = 0.1", "alpha = 0.1\nxsph = 0.1").find("without method = \"sph\"") !=
          std::string::npos);
    CHECK(complaint("dim = 2", "dim = 2\nno_slip = true").find("walls that slip") !=
          std::string::npos);
    CHECK(complaint("end = ", "step = 0.1\nlargest_step = 0.1\nend = ").find("steps that adapt") !=
          std::string::npos);
}

TEST_CASE("shapes without extent and open sides that a shape does not have are refused") {
    CHECK(complaint("high = [0.6, 0.3]", "high = [0.6, 0.0]").find("a corner above") !=
          std::string::npos);
    CHECK(complaint("\"+y\"", "\"+z\"") ==
          "s.toml:22:9: expected a list of words among \"-x\" \"+x\" \"-y\" \"+y\", found \"+z\"");
    CHECK(complaint("shape = \"box\"", "shape = \"cone\"") ==
          "s.toml:15:9: expected one of \"box\", \"sphere\", found \"cone\"");
}

TEST_CASE("probes have names of their own, and heights need gravity") {
    const std::string probe = "[[probe]]\nname = \"a\"\nquantity = \"height\"\nat = [0, 0]\n";
    const std::string twice = good + probe + probe;
    CHECK(complaint("dim = 2", "dim = 2", twice).find("\"a\" twice") != std::string::npos);
    CHECK(complaint("[0, -9.81]", "[0, 0]", good + probe).find("gravity where a height") !=
          std::string::npos);
}
}  // namespace
}  // namespace scene_file_test
