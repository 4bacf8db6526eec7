#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/comparison.h"
#include "reports/files.h"
#include "reports/interrupt.h"
#include "reports/page/page.h"
#include "reports/pieces.h"
#include "reports/read_json.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace reports::report_command {
namespace {
struct Options {
    std::string folder = "report", baseline;
    bool quick = false, json = false;
};

Json changes_since(const Json& baseline, const Json& report) {
    const Json none = Json::object();
    const Json provenance = baseline.value("provenance", none);
    Json rows = Json::array();
    for (const Change& change : compare(baseline, report)) rows.push_back(json_of(change));
    return {{"version", provenance.value("version", "unknown")},
            {"started", provenance.value("started", "an unknown time")},
            {"rows", std::move(rows)}};
}

/// A failed check weighs more than one that cannot be told.
ExitCode judge(const Json& report) {
    std::vector<std::string> verdicts;
    for (const Json& claim : report["claims"]) verdicts.push_back(claim["verdict"]);
    for (const Json& study : report["studies"]) {
        if (study.contains("error")) return ExitCode::check_failed;
        for (const Json& series : study["series"]) verdicts.push_back(series["verdict"]);
    }
    for (const Json& map : report.value("maps", Json::array())) verdicts.push_back(map["verdict"]);
    const auto any = [&](const char* colour) {
        return std::ranges::any_of(verdicts,
                                   [&](const auto& v) { return colour_class(v) == colour; });
    };
    if (any("bad")) return ExitCode::check_failed;
    return any("open") ? ExitCode::inconclusive : ExitCode::ok;
}

ExitCode make_report(const Options& options) {
    // A baseline that cannot be read should not cost the minutes of the measurements.
    const Json baseline = options.baseline.empty() ? Json() : read_json(options.baseline);
    const std::filesystem::path folder = options.folder;
    Pieces pieces(folder / "pieces", fingerprint(options.quick ? "quick" : "full"));
    ReportRun run{{{"schema", "plumbline.report/1"},
                   {"provenance", json_of(provenance())},
                   {"quick", options.quick}},
                  pieces,
                  options.quick};
    for (const Section& section : sections()) {
        stop_if_interrupted();
        section.measure(run);
    }
    if (!baseline.is_null()) run.report["changes"] = changes_since(baseline, run.report);
    std::filesystem::create_directories(folder);
    const std::filesystem::path data = folder / "report.json", page = folder / "index.html";
    write_file(data, lines(run.report));
    write_file(page, page_of(run.report, folder / "charts"));
    if (pieces.reused() > 0)
        fmt::print(stderr, "plumbline: {} were there already and still hold\n",
                   counted(static_cast<std::size_t>(pieces.reused()), "piece"));
    if (options.json) write_json(run.report, "-");
    fmt::print(stderr, "plumbline: the page is {}\n", std::filesystem::absolute(page).string());
    return judge(run.report);
}

const RegisterCommand command{
    {"report", "everything, in one HTML page that opens offline",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("-o,--output", options->folder,
                         "the folder for index.html, report.json and the charts; a run that was "
                         "interrupted continues from what is there")
             .check(output_folder())
             .show_default();
         line.add_flag("--quick", options->quick, "coarser studies, smaller clouds: minutes");
         line.add_option("--baseline", options->baseline, "compare with this earlier report.json");
         line.add_flag("--json", options->json, "write the report to stdout as JSON, too");
         return [options] { return make_report(*options); };
     }}};
}  // namespace
}  // namespace reports::report_command
