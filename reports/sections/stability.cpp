#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/stability_report.h"
#include "reports/words.h"

#include <fmt/format.h>

namespace reports::stability_section {
namespace {
using namespace verification;

void measure_maps(ReportRun& run) {
    run.report["maps"] = run_maps(maps(), run.quick ? Effort::quick : Effort::full, run.pieces);
}

std::string ratios_of(const Json& points) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Json& p : points) {
        const double ratio = value_of(p["ratio"]);
        if (std::isnan(ratio)) continue;
        low = std::min(low, ratio);
        high = std::max(high, ratio);
    }
    return low > high ? "none" : fmt::format("{:.3f} to {:.3f}", low, high);
}

Json row_of(const Json& line) {
    const std::string verdict = line["verdict"];
    return {{"name", line["name"]},
            {"verdict", verdict},
            {"class", colour_class(verdict)},
            {"runs", line["points"].size()},
            {"ratios", ratios_of(line["points"])},
            {"expected", bound_in_words(line["expected"])},
            {"why", line["expected"]["why"]}};
}

Json view(const Json& report) {
    if (report.value("maps", Json::array()).empty()) return nullptr;
    Json rows = Json::array();
    for (const Json& map : report["maps"]) {
        Json row = {{"id", map["id"]},
                    {"finding", map["finding"]},
                    {"source", map["source"]["paper"].get<std::string>() + " " +
                                   map["source"]["place"].get<std::string>()},
                    {"chart", map["chart"]},
                    {"lines", Json::array()}};
        for (const Json& line : map["lines"])
            if (line["tested"].get<bool>()) row["lines"].push_back(row_of(line));
        rows.push_back(std::move(row));
    }
    return {{"maps", rows}};
}

const RegisterSection section{
    {50, "stability", "Where do fluids break?", measure_maps, view, templates::stability}};
}  // namespace
}  // namespace reports::stability_section
