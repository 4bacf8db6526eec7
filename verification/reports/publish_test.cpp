#include "verification/reports/program.h"

#include <catch2/catch.hpp>

namespace publish_test {
namespace {
using verification::ProgramRun;
using verification::ScratchFolder;

std::string report_of(const std::string& version) {
    return R"({"schema": "plumbline.report/1", "provenance": {"version": ")" + version + R"("}})";
}

/// A report of `version` with one chart, published.
ProgramRun published(const ScratchFolder& folder, const std::string& report,
                     const std::string& chart = "errors") {
    std::filesystem::create_directories(folder.path() / "report" / "charts");
    folder.write("report/report.json", report);
    folder.write("report/charts/errors.png", "a picture");
    return run_plumbline(folder, {"publish", "report", "--chart", chart, "-o", "published"});
}

TEST_CASE("charts of a clean commit are published with their provenance") {
    const ScratchFolder folder;
    const ProgramRun run = published(folder, report_of("v1-2-gabc"));
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK(folder.read("published/errors.png") == "a picture");
    CHECK(folder.read("published/provenance.json").find("v1-2-gabc") != std::string::npos);
}

TEST_CASE("nothing is published that no commit can draw again, or that is not there") {
    for (const auto& [report, chart, message] :
         {std::tuple{report_of("v1-dirty"), "errors", "expected the report of a clean commit"},
          {report_of("unknown"), "errors", "expected the report of a clean commit"},
          {std::string(R"({"schema": "other"})"), "errors", "expected a report with the schema"},
          {std::string("{"), "errors", "report.json:1:"},
          {report_of("v1"), "no_such_chart", "no_such_chart.png"}}) {
        const ScratchFolder folder;
        const ProgramRun run = published(folder, report, chart);
        INFO(report << run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.err.find(message) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(folder.path() / "published"));
    }
}
}  // namespace
}  // namespace publish_test
