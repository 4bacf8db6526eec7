#include "reports/comparison.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"

#include <fmt/format.h>

#include <map>

namespace reports::changes_section {
namespace {
std::string class_of(const std::string& verdict) {
    return verdict == "worse" ? "bad" : verdict == "cannot tell" ? "open" : "ok";
}

Json view(const Json& report) {
    if (!report.contains("changes")) return nullptr;
    std::map<std::string, int> counts;
    Json rows = Json::array();
    for (Json row : report["changes"]["rows"]) {
        const std::string verdict = row["verdict"];
        ++counts[verdict];
        if (verdict == "same") continue;
        row["class"] = class_of(verdict);
        rows.push_back(std::move(row));
    }
    return {{"old_version", report["changes"]["version"]},
            {"old_started", report["changes"]["started"]},
            {"summary",
             fmt::format("{} worse, {} better, {} the same, {} cannot be told", counts["worse"],
                         counts["better"], counts["same"], counts["cannot tell"])},
            {"rows", rows}};
}

/// The baseline is compared with the finished report, so there is nothing to measure here.
const RegisterSection section{
    {20, "changes", "What has changed", [](ReportRun&) {}, view, templates::changes}};
}  // namespace
}  // namespace reports::changes_section
