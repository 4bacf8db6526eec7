#include "reports/noise_floor.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

namespace reports::provenance_section {
namespace {
void measure(ReportRun& run) {
    run.report["noise"] = run.piece("noise", "measuring the noise floor of this machine", [] {
        const NoiseFloor floor = measure_noise_floor();
        return Json{{"relative", floor.relative},
                    {"spread", floor.spread},
                    {"seconds", floor.seconds},
                    {"rounds", floor.rounds},
                    {"runs", floor.runs}};
    });
}

Json pairs(const Json& object) {
    Json rows = Json::array();
    for (const auto& [key, value] : object.items())
        rows.push_back({{"key", key}, {"value", value}});
    return rows;
}

Json view(const Json& report) {
    Json shown = report["provenance"];
    shown["memory_gb"] = fmt::format("{:.1f}", shown.value("memory_gb", 0.0));
    shown["libraries"] = pairs(shown["libraries"]);
    shown["seeds"] = pairs(shown["seeds"]);
    shown["schema"] = report["schema"];
    if (report.contains("noise"))
        shown["noise"] = {
            {"percent", fmt::format("{:.2g}", 100.0 * report["noise"]["relative"].get<double>())},
            {"spread", fmt::format("{:.2g}", 100.0 * report["noise"]["spread"].get<double>())},
            {"rounds", report["noise"]["rounds"]},
            {"runs", report["noise"]["runs"]}};
    return shown;
}

const RegisterSection section{
    {100, "provenance", "Where these numbers come from", measure, view, templates::provenance}};
}  // namespace
}  // namespace reports::provenance_section
