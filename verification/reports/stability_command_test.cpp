#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace stability_command_test {
namespace {
using namespace verification;
using nlohmann::json;
}  // namespace

TEST_CASE("every map of stability has its border where theory has it, at the quick level") {
    const ScratchFolder folder;
    const ProgramRun run =
        run_plumbline(folder, {"stability", "--quick", "-o", "charts", "--json", "maps.json"}, 600);
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    for (const json& map : json::parse(folder.read("maps.json")).at("maps")) {
        INFO(map.at("id"));
        CHECK(map.at("verdict") == "verified");
        const std::string chart = "charts/stability_" + map.at("id").get<std::string>();
        CHECK_FALSE(folder.read(chart + ".svg").empty());
        const std::string table = folder.read(chart + ".csv");
        CHECK(std::ranges::count(table, '\n') > 10);
        CHECK(table.find("runs") != std::string::npos);
    }
}

TEST_CASE("stability names what there is if no map matches") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"stability", "nonsense"});
    CHECK(run.exit_code == 3);
    CHECK(run.err.find("list maps") != std::string::npos);
}

}  // namespace stability_command_test
