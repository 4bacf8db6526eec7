#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace sample_command_test {
namespace {
using namespace verification;
using nlohmann::json;

/// The corner x, y, z >= 0, x + y + z <= 1: a sixth of its box.
const std::string corner =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}  // namespace

TEST_CASE("plumbline sample: points in the unit square, as CSV that neighbours reads") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"sample", "hexagonal", "--count", "200"});
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.starts_with("x,y\n"));
    CHECK(std::ranges::count(run.out, '\n') > 150);
    folder.write("points.csv", run.out);
    CHECK(run_plumbline(folder, {"neighbours", "--points", "points.csv", "--repeats", "1",
                                 "--search", "cell_grid"})
              .exit_code == 0);
}

TEST_CASE("plumbline sample: inside a closed mesh") {
    const ScratchFolder folder;
    folder.write("corner.obj", corner);
    const ProgramRun run = run_plumbline(folder, {"sample", "halton", "--dim", "3", "--count",
                                                  "1000", "--inside", "corner.obj", "--json", "-"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const json document = json::parse(run.out);
    CHECK(document.at("schema") == "plumbline.sample/1");
    CHECK(document.at("provenance").contains("version"));
    const json& points = document.at("sample").at("points");
    CHECK(points.size() >
          950);  // of Halton points a share of the box within some log³ n / n of its own
    CHECK(points.size() < 1050);
    for (const json& x : points)
        CHECK(x[0].get<double>() + x[1].get<double>() + x[2].get<double>() <= 1.0);
}

TEST_CASE("plumbline sample says what is wrong with it") {
    const ScratchFolder folder;
    folder.write("corner.obj", corner);
    folder.write("open.obj", corner.substr(0, corner.rfind("f ")));
    const std::vector<std::pair<std::vector<std::string>, std::string>> table{
        {{"sample"}, "is required"},
        {{"sample", "sphere"}, "no sampling \"sphere\" in 2D; expected one of: lattice"},
        {{"sample", "hexagonal", "--dim", "3"}, "no sampling \"hexagonal\" in 3D"},
        {{"sample", "lattice", "--count", "0"}, "Value 0 not in range 1 to"},
        {{"sample", "lattice", "--inside", "corner.obj"}, "expected --dim 3 beside it, found 2"},
        {{"sample", "lattice", "--dim", "3", "--inside", "nowhere.obj"}, "nowhere.obj"},
        {{"sample", "lattice", "--dim", "3", "--inside", "open.obj"},
         "expected a closed surface, found "},
        {{"sample", "lattice", "--json", "no/folder.json"}, "its folder does not exist"}};
    for (const auto& [arguments, message] : table) {
        const ProgramRun run = run_plumbline(folder, arguments);
        INFO(message << "\nstderr: " << run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.err.find(message) != std::string::npos);
        CHECK(run.out.empty());
    }
}

}  // namespace sample_command_test
