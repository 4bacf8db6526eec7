#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace validate_command_test {
namespace {
using namespace verification;
using nlohmann::json;
}  // namespace

TEST_CASE("plumbline validate compares a dam break with its experiment") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(
        folder, {"validate", "--quick", "dam_break_tall", "-o", "charts", "--json", "-"}, 600);
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    const json validation = json::parse(run.out).at("validations").at(0);
    for (const json& q : validation.at("quantities")) {
        INFO(q);
        CHECK(q.at("simulated").size() == validation.at("spacing").size());
        const double u_num = q.at("u_num"), u_input = q.at("u_input"), u_data = q.at("u_data");
        CHECK(q.at("u_val").get<double>() == Approx(std::hypot(u_num, u_input, u_data)));
        const bool agrees = std::abs(q.at("error").get<double>()) <= q.at("u_val").get<double>();
        CHECK(q.at("verdict") == (agrees ? "agrees" : "differs"));
    }
    const std::string table = folder.read("charts/validation_dam_break_tall_1.csv");
    CHECK(table.find("measured") != std::string::npos);
    CHECK(table.find("spacing 0.125 m") != std::string::npos);
    CHECK_FALSE(folder.read("charts/validation_dam_break_tall_2.svg").empty());
}

TEST_CASE("validate names what there is if no validation matches") {
    const ScratchFolder folder;
    const ProgramRun run = run_plumbline(folder, {"validate", "nonsense"});
    CHECK(run.exit_code == 3);
    CHECK(run.err.find("list validations") != std::string::npos);
    const ProgramRun slow = run_plumbline(folder, {"validate", "--quick", "lid_driven_cavity"});
    CHECK(slow.exit_code == 3);
    CHECK(slow.err.find("without --quick") != std::string::npos);
}

}  // namespace validate_command_test
