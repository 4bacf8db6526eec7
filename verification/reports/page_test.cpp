#include "reports/page/page.h"

#include "reports/charts/chart_json.h"
#include "reports/files.h"
#include "reports/frontier_report.h"
#include "verification/reports/page_example_test.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>

namespace page_test {
namespace {
using reports::Json;
using verification::small_report;

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}
}  // namespace

TEST_CASE("the page says what the report found, and needs nothing beside itself") {
    const auto charts = std::filesystem::temp_directory_path() / "plumbline_page_test";
    std::filesystem::remove_all(charts);
    const std::string page = reports::page_of(small_report(), charts);
    CHECK(count(page, "data:image/svg+xml;base64,") == 1);
    CHECK(page.find("alt=\"a falling line\"") != std::string::npos);
    CHECK(count(page, "<details>") >= 2);
    CHECK(page.find("<b>1 / 2</b>") != std::string::npos);
    CHECK(page.find("1 failed, 0 toothless") != std::string::npos);
    CHECK(page.find("&lt;script&gt;") != std::string::npos);
    for (const char* forbidden : {"<script", "http://", "https://", "url(", "@import", "{{"})
        CHECK(count(page, forbidden) == 0);
    CHECK(page == reports::page_of(small_report(), charts));
}

TEST_CASE("sections without content are left out") {
    const Json empty = {{"schema", "plumbline.report/1"},
                        {"provenance",
                         {{"version", "v1"},
                          {"started", ""},
                          {"processor", ""},
                          {"libraries", Json::object()},
                          {"seeds", Json::object()}}}};
    const std::string page =
        reports::page_of(empty, std::filesystem::temp_directory_path() / "plumbline_page_test");
    CHECK(count(page, "<section") == 2);  // the answers, and where the numbers come from
    CHECK(count(page, "<li class=\"tile") == 0);
}

TEST_CASE("a chart is the same after a round through JSON") {
    const Json json = small_report()["studies"][0]["chart"];
    CHECK(json_of(reports::chart_from(json), "s") == json);
}

TEST_CASE(
    "the page has the front of a frontier with what it takes, and all that was measured as a "
    "file") {
    const auto candidate = [](const char* method, double seconds, double error) {
        benchmarks::Candidate c{};
        c.method = method;
        c.kernel = "cubic_spline";
        c.dim = 2;
        c.support_in_spacings = 3.5;
        c.samples_per_metre = 40;
        c.places = 10;
        c.error = error;
        c.largest_error = 2.0 * error;
        c.evaluation = {seconds, 0.0};
        c.application = c.precomputation = {seconds, 0.0};
        return c;
    };
    benchmarks::Frontier frontier{verification::Quantity::value,
                                  2,
                                  {candidate("SPH Eq. 3", 1e-6, 1e-2),
                                   candidate("MLS 2", 1e-5, 1e-4), candidate("MLS 3", 1e-4, NAN)},
                                  0.01,
                                  {},
                                  "a finding"};
    frontier.candidates[1].on_front = true;
    frontier.precomputed = precomputed_ratios(frontier.candidates, frontier.noise);
    Json json = reports::json_of(frontier);
    json["charts"] = Json::array();
    Json report = small_report();
    report["frontiers"] = Json::array({json});
    const auto charts = std::filesystem::temp_directory_path() / "plumbline_page_frontier_test";
    std::filesystem::remove_all(charts);
    const std::string page = reports::page_of(report, charts);
    const std::string row =
        "<tr><td>MLS 2</td><td>cubic_spline</td><td class=\"number\">3.5</td><td "
        "class=\"number\">1600</td>";
    CHECK(count(page, row) == 1);
    CHECK(page.find("download=\"frontier_approximation_2d.csv\" href=\"data:text/csv;base64,") !=
          std::string::npos);
    CHECK(page.find(">never<") != std::string::npos);
    const std::string table = reports::read_file(charts / "frontier_approximation_2d.csv");
    CHECK(table.starts_with("method,kernel,support_in_spacings,samples_per_metre,samples,"));
    CHECK(count(table, "\n") == 1 + 3);
    CHECK(count(table, "MLS 2,cubic_spline,3.5,40,1600,") == 1);
    CHECK(count(table, "not a number") == 1);
}

TEST_CASE("what does not help is named with the worst first") {
    Json report = small_report();
    Json& series = report["studies"][0]["series"];
    series[0]["level_errors"] = {1.0, 0.5};
    Json worse = series[0], sabotaged = series[0];
    worse["name"] = "worse";
    worse["level_errors"] = {1.0, 0.9};
    sabotaged["sabotaged"] = true;
    series.push_back(worse);
    series.push_back(sabotaged);
    const std::string page =
        reports::page_of(report, std::filesystem::temp_directory_path() / "plumbline_page_test");
    CHECK(
        page.find("does not help 2 of 2 series, the error rests on a floor; the worst are s/worse, "
                  "s/mls.") != std::string::npos);
}

}  // namespace page_test
