#include "reports/neighbours_charts.h"
#include "reports/neighbours_plan.h"
#include "solver/foundation/errors.h"
#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace neighbours_command_test {
namespace {
using namespace verification;
using nlohmann::json;

const std::string three_points = "x,y,z\n0,0,0\n1,0,0\n0,0,5\n";
}  // namespace

TEST_CASE("plumbline neighbours: JSON has every search, that it agrees, its times and its place") {
    const ScratchFolder folder;
    folder.write("three.csv", three_points);
    const ProgramRun run =
        run_plumbline(folder, {"neighbours", "--points", "three.csv", "--radius", "1.5",
                               "--repeats", "7", "--moved", "0.5", "--json", "-"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const json document = json::parse(run.out);
    CHECK(document.at("schema") == "plumbline.neighbours/1");
    CHECK(document.at("noise").at("relative").is_number());
    const json& study = document.at("neighbours").at("studies").at(0);
    const json& c = study.at("cases").at(0);
    CHECK(c.at("count") == 3);
    CHECK(c.at("mean_neighbours").get<double>() == Approx(5.0 / 3.0));  // 2, 2, 1
    CHECK(c.at("brute_force_rows") == 3);
    int places = 0;
    for (const json& search : c.at("searches")) {
        CHECK(search.at("wrong_pairs") == 0);
        CHECK(search.at("build").at("runs_s").size() == 7);
        CHECK(search.at("update").at("median_s").get<double>() > 0.0);
        const bool ranked = search.contains("first_place");
        CHECK(search.contains("last_place") == ranked);
        if (ranked) CHECK(search.at("first_place") <= search.at("last_place"));
        places += ranked ? 1 : 0;
    }
    CHECK(places >= 6);
}

TEST_CASE("plumbline neighbours: radii from a column of the file, one for each point") {
    const ScratchFolder folder;
    folder.write("radii.csv", "x,y,z,r,h\n0,0,0,1.5,9\n1,0,0,0.5,9\n0,0,5,6,9\n");
    const auto neighbours_with = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"neighbours", "--points", "radii.csv", "--repeats", "6"});
        options.insert(options.end(), {"--json", "-"});
        const ProgramRun run = run_plumbline(folder, options);
        INFO(run.err);
        REQUIRE(run.exit_code == 0);
        const json c = json::parse(run.out).at("neighbours").at("studies").at(0).at("cases").at(0);
        CHECK(c.at("own_radii") == true);
        return 3.0 * c.at("mean_neighbours").get<double>();
    };
    CHECK(neighbours_with({"--radii"}) == Approx(2 + 1 + 3));  // the farthest is sqrt(26) away
    CHECK(neighbours_with({"--radii", "h"}) == Approx(9));
}

TEST_CASE("plumbline neighbours writes charts, their tables, and one table of everything") {
    const ScratchFolder folder;
    const ProgramRun run =
        run_plumbline(folder, {"neighbours", "--count", "200", "--count", "1000", "--repeats", "6",
                               "--search", "cell_grid", "--search", "kd_tree", "-o", "out"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    for (const char* name : {"rate", "phases", "queries", "memory"})
        CHECK_FALSE(folder.read(std::string("out/neighbours_size_") + name + ".svg").empty());
    const std::string table = folder.read("out/neighbours.csv");
    CHECK(std::ranges::count(table, '\n') == 1 + 2 * 2);
    CHECK(run.out.find("time ~ points^exponent") != std::string::npos);
}

TEST_CASE("plumbline neighbours says what an option must be") {
    const ScratchFolder folder;
    folder.write("three.csv", three_points);
    folder.write("zero.csv", "x,y,r\n0,0,1\n1,0,0\n");
    const std::vector<std::pair<std::vector<std::string>, std::string>> table{
        {{"--points", "three.csv", "--radius", "0"}, "expected a radius in [1e-150, 1e+150]"},
        {{"--points", "three.csv", "--radius", "wide"}, "Could not convert: --radius = wide"},
        {{"--points", "three.csv", "--cloud", "line"}, "--points excludes --cloud"},
        {{"--points", "three.csv", "--radius", "1", "--own-radii"}, "expected none beside"},
        {{"--points", "three.csv", "--radii", "h"},
         "expected a column \"h\", found coordinates only"},
        {{"--points", "zero.csv", "--radii"}, "found 0 (column \"r\", point 2)"},
        {{"--points", "zero.csv", "--radii", "--radius", "1"}, "--radius excludes --radii"},
        {{"--radii", "r"}, "--radii requires --points"},
        {{"--cloud", "sphere"}, "sphere not in {jittered,"},
        {{"--order", "sideways"}, "sideways not in {as_given,"},
        {{"--moved", "1.5"}, "--moved: expected a number from 0 to 1, found 1.5"},
        {{"--moved", "nan"}, "--moved: expected a number from 0 to 1, found nan"},
        {{"--spacings", "0"}, "--spacings: expected a number from 0.1 to 100, found 0"},
        {{"--contrast", "0.5"}, "--contrast: expected a number from 1 to 1e+09, found 0.5"},
        {{"--cloud", "line", "--contrast", "10"}, "expected a cloud that has one"},
        {{"--count", "0"}, "Value 0 not in range 1 to 100000000"},
        {{"--search", "telepathy"}, "telepathy not in {cell_grid,"},
        {{"--study", "everything"}, "everything not in {all,size,"},
        {{"--study", "size", "--count", "10"}, "--count excludes --study"},
        {{"--count", "200000", "--radius", "9", "--search", "cell_grid"}, "makes lists of"}};
    for (auto [arguments, message] : table) {
        arguments.insert(arguments.begin(), "neighbours");
        const ProgramRun run = run_plumbline(folder, arguments);
        INFO(message << "\nstderr: " << run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.err.find(message) != std::string::npos);
        CHECK(run.out.empty());
    }
}

TEST_CASE("a request is the product of its values, in studies along its main axis") {
    reports::NeighbourRequest request;
    request.counts = {1000, 2000, 3000};
    request.orders = {"shuffled", "hilbert"};
    const auto sizes = reports::plan(request);
    REQUIRE(sizes.size() == 2);
    CHECK(sizes[0].name == "size");
    CHECK(sizes[0].situations.size() == 3);
    request.contrasts = {1, 10};
    const auto contrasts = reports::plan(request);
    REQUIRE(contrasts.size() == 2);
    CHECK(contrasts[1].name == "contrast");
    CHECK(contrasts[1].situations.size() == 6);
    CHECK(contrasts[1].situations[0].cloud.name == "graded");
    CHECK(reports::plan({})[0].name == "points");
}

TEST_CASE("every study has a chart, also where nothing can be told") {
    benchmarks::ComparisonOptions how;
    how.least = how.most = 1;
    how.searches = {"cell_grid", "kd_tree"};
    for (const auto& study : benchmarks::search_studies(benchmarks::Level::quick)) {
        INFO(study.name);
        benchmarks::SearchStudyResult result{study.name, study.question, {}};
        for (benchmarks::SearchSituation s : study.situations) {
            s.cloud.count = 200;
            result.cases.push_back(benchmarks::measure(s, how));
        }
        const auto charts = reports::charts_of(result, "plumbline neighbours");
        CHECK_FALSE(charts.empty());
        for (const auto& named : charts) {
            CHECK_FALSE(named.chart.finding.empty());
            CHECK_FALSE(named.chart.alt.empty());
        }
    }
}

}  // namespace neighbours_command_test
