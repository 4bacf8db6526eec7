#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace list_command_test {
namespace {
using namespace verification;
using nlohmann::json;

json listed(const std::string& kind) {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"list", kind, "--json"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return json::parse(run.out).at("list").at(kind);
}

/// What is said of the entry of that id; empty if there is none.
std::string says(const json& entries, const std::string& id) {
    for (const json& entry : entries)
        if (entry.at("id") == id) return entry.at("says");
    return {};
}
}  // namespace

TEST_CASE("plumbline list: every kind has entries, each with an id and what it is") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"list", "--json"});
    REQUIRE(run.exit_code == 0);
    const json list = json::parse(run.out).at("list");
    for (const char* kind : {"claims", "studies", "maps", "validations", "errata", "statements",
                             "methods", "searches", "kernels", "samplings", "scenes"}) {
        INFO(kind);
        REQUIRE_FALSE(list.at(kind).empty());
        for (const json& entry : list.at(kind)) {
            CHECK_FALSE(entry.at("id").get<std::string>().empty());
            CHECK_FALSE(entry.at("says").get<std::string>().empty());
        }
    }
}

TEST_CASE("plumbline list: samplings and kernels with the dimensions that they have") {
    const json samplings = listed("samplings");
    CHECK(says(samplings, "lattice").starts_with("1D 2D 3D,"));
    CHECK(says(samplings, "hexagonal").starts_with("2D,"));
    CHECK(says(samplings, "close_packed").starts_with("3D,"));
    const json kernels = listed("kernels");
    CHECK(says(kernels, "poly6") == "kernel in 1D 2D 3D");
    CHECK(says(kernels, "singular") == "kernel in 2D 3D");
}

TEST_CASE("plumbline list: methods of approximate, and of the frontiers with their tasks") {
    const json methods = listed("methods");
    CHECK(says(methods, "mls:3").starts_with("approximate: "));
    CHECK(says(methods, "SPH Eq. 13") == "frontier gradient");
    CHECK(says(methods, "MLS 2") == "frontier approximation gradient laplacian");
    CHECK(says(methods, "DFSPH") == "frontier taylor_green hydrostatic dam_break");
}

TEST_CASE("plumbline list: the searches are those that neighbours takes") {
    const ScratchFolder folder;
    folder.write("three.csv", "x,y\n0,0\n1,0\n0,5\n");
    std::size_t searches = 0;
    for (const json& entry : listed("searches")) {
        const std::string id = entry.at("id");
        if (id == "brute_force") continue;
        INFO(id);
        CHECK(run_plumbline(folder, {"neighbours", "--points", "three.csv", "--radius", "2",
                                     "--repeats", "1", "--search", id})
                  .exit_code == 0);
        ++searches;
    }
    CHECK(searches >= 8);
}

TEST_CASE("plumbline list: validations are the comparisons with experiments") {
    const json validations = listed("validations");
    CHECK(says(validations, "dam_break_tall").find("front") != std::string::npos);
    CHECK(says(validations, "poly6.is_smooth").empty());
}

TEST_CASE("plumbline --version names the version, and nothing else") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"--version"});
    CHECK(run.exit_code == 0);
    CHECK(run.out.starts_with("plumbline "));
    CHECK(std::ranges::count(run.out, '\n') == 1);
    CHECK(run.err.empty());
}

}  // namespace list_command_test
