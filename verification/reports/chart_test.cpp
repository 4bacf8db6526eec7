#include "reports/charts/chart.h"

#include "reports/charts/gnuplot.h"
#include "reports/charts/study_chart.h"
#include "reports/files.h"
#include "solver/foundation/errors.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <set>

namespace chart_test {
namespace {
using reports::Chart;

Chart example() {
    return {
        .finding = "MLS \"a_b\" beats <SPH> & {others} at every spacing that was tried in this run",
        .x = {"spacing", "m", true},
        .y = {"error_of_f", "1", true},
        .series = {{.name = "sph_1, \"raw\"",
                    .x = {0.1, 0.05, 0.025},
                    .y = {0.02, 0.021, 0.0205},
                    .y_range = {{0.01, 0.03}, {0.02, 0.022}, {-1.0, 0.03}},
                    .failures = {0.0125}},
                   {.name = "mls", .x = {0.1, 0.05, 0.025}, .y = {0.01, NAN, 0.0}}},
        .slopes = {1, 2},
        .caption = "",
        .alt = "two series",
        .command = "plumbline converge"};
}

std::filesystem::path fresh_directory(const char* name) {
    const auto directory = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove_all(directory);
    return directory;
}
}  // namespace

TEST_CASE("a chart becomes an SVG, a PNG and a table twin") {
    const auto files = reports::draw(example(), fresh_directory("plumbline_drawn"), "example");
    const std::string svg = reports::read_file(files.svg);
    CHECK(svg.find("<title>MLS \"a_b\" beats &lt;SPH&gt; &amp; {others}") != std::string::npos);
    CHECK(svg.find("error_of_f [1]") != std::string::npos);
    CHECK(reports::read_file(files.png).substr(1, 3) == "PNG");
    CHECK(reports::read_file(files.csv) ==
          "series,x,x_low,x_high,y,y_low,y_high,status\n"
          "\"sph_1, \"\"raw\"\"\",0.10000000000000001,0.10000000000000001,0.10000000000000001,0.02,"
          "0.01,0.029999999999999999,ok\n"
          "\"sph_1, \"\"raw\"\"\",0.050000000000000003,0.050000000000000003,0.050000000000000003,"
          "0.021000000000000001,0.02,0.021999999999999999,ok\n"
          "\"sph_1, \"\"raw\"\"\",0.025000000000000001,0.025000000000000001,0.025000000000000001,"
          "0.020500000000000001,-1,0.029999999999999999,ok\n"
          "\"sph_1, \"\"raw\"\"\",0.012500000000000001,,,,,,failed\n"
          "mls,0.10000000000000001,0.10000000000000001,0.10000000000000001,0.01,0.01,0.01,ok\n"
          "mls,0.050000000000000003,0.050000000000000003,0.050000000000000003,nan,nan,nan,failed\n"
          "mls,0.025000000000000001,0.025000000000000001,0.025000000000000001,0,0,0,ok\n");
}

TEST_CASE("a chart with lists of different lengths, or with nothing to show, is refused") {
    Chart uneven = example();
    uneven.series[0].y.pop_back();
    CHECK_THROWS_AS(reports::draw(uneven, fresh_directory("plumbline_refused"), "x"),
                    plumbline::InvalidInput);
    Chart empty = example();
    empty.series.clear();
    CHECK_THROWS_AS(reports::draw(empty, fresh_directory("plumbline_refused"), "x"),
                    plumbline::InvalidInput);
    Chart linear = example();
    linear.y.log = false;
    CHECK_THROWS_AS(reports::draw(linear, fresh_directory("plumbline_refused"), "x"),
                    plumbline::InvalidInput);
}

TEST_CASE("the first 28 series can be told apart without colour") {
    std::set<std::pair<int, std::string>> styles;
    for (int k = 0; k < 28; ++k)
        styles.emplace(reports::style_of(k).marker, reports::style_of(k).dash);
    CHECK(styles.size() == 28);
}

TEST_CASE("a series of outlines is told apart from each filled one") {
    for (int k = 0; k < 7; ++k) {
        Chart chart = example();
        chart.series.resize(1);
        chart.series[0].style = k;
        const std::string filled = reports::gnuplot_script(chart, {"a.svg", "a.png", "a.csv"});
        chart.series[0].open = true;
        CHECK(reports::gnuplot_script(chart, {"a.svg", "a.png", "a.csv"}) != filled);
    }
}

TEST_CASE("the first ten series have ten colours") {
    std::set<std::string> colours;
    for (int k = 0; k < 10; ++k) colours.insert(reports::style_of(k).colour);
    CHECK(colours.size() == 10);
}

TEST_CASE("what failed keeps its marker under the cross, filled or open") {
    Chart chart = example();
    chart.series[1].open = true;
    chart.series[1].failures = {0.0125};
    const std::string script = reports::gnuplot_script(chart, {"a.svg", "a.png", "a.csv"});
    const auto style = [](int k) {
        return "lc rgb '" + reports::style_of(k).colour + "' pt " +
               std::to_string(reports::style_of(k).marker - k);  // the outline is the one before
    };
    CHECK(script.find("$rim0 using 1:2 with points " + style(0)) != std::string::npos);
    CHECK(script.find("$rim1 using 1:2 with points " + style(1)) != std::string::npos);
    CHECK(script.find("$rim1 using 1:2 with points lc rgb '" + reports::style_of(1).colour +
                      "' pt 2") != std::string::npos);
}

TEST_CASE("the chart of a study has no order -0.0, and says of one seed that it is one") {
    using namespace verification;
    SeriesResult rests{.name = "sph",
                       .expected_order = at_least(1.0, ""),
                       .expected_saturation = false,
                       .errors = {{0.1}, {0.1001}},
                       .fit = {},
                       .verdict = Verdict::saturated};
    rests.fit.order = -0.04;
    rests.fit.error = {0.1, 0.1001};
    SeriesResult falls = rests;
    falls.name = "mls";
    falls.errors = {{1e-2}, {5e-4}};
    falls.fit.order = 2.0;
    falls.fit.error = {1e-2, 5e-4};
    StudyResult result{};
    result.study.says = "it converges";
    result.spacing = {0.1, 0.05};
    result.seeds = 1;
    result.series = {rests, falls};
    const Chart chart = reports::chart_of(result);
    CHECK(chart.finding == "mls (order 2.0) ends 200 times below sph (order 0.0)");
    CHECK(chart.series[0].name == "sph: order 0.0");
    CHECK(chart.caption.find("Nothing is random") != std::string::npos);
}

}  // namespace chart_test
