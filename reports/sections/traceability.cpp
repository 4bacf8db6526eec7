#include "verification/framework/traceability.h"

#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

namespace reports::traceability_section {
namespace {
/// A statement is as good as the worst of its claims.
std::string worst_verdict(const Json& claims, const Json& ids) {
    std::string worst = ids.empty() ? "no claim" : "verified";
    for (const Json& claim : claims) {
        if (std::ranges::find(ids, claim["id"]) == ids.end()) continue;
        const std::string verdict = claim["verdict"];
        if (verdict != "verified" && worst != "failed") worst = verdict;
    }
    return worst;
}

void collect(ReportRun& run) {
    run.report["statements"] = Json::array();
    for (const verification::Statement& statement : verification::statements()) {
        Json ids = Json::array();
        for (const verification::Claim* claim : claims_of(statement)) ids.push_back(claim->id);
        const std::string verdict = worst_verdict(run.report["claims"], ids);
        run.report["statements"].push_back({{"paper", name_of(statement.paper)},
                                            {"item", statement.item},
                                            {"says", statement.says},
                                            {"claims", std::move(ids)},
                                            {"verdict", verdict}});
    }
}

Json view(const Json& report) {
    if (report.value("statements", Json::array()).empty()) return nullptr;
    Json rows = Json::array();
    for (Json row : report["statements"]) {
        row["class"] = colour_class(row["verdict"]);
        row["count"] = row["claims"].size();
        rows.push_back(std::move(row));
    }
    return {{"rows", rows},
            {"total", rows.size()},
            {"good", count_verdict(rows, "verified")},
            {"without", count_verdict(rows, "no claim")}};
}

const RegisterSection section{{80, "traceability", "From each equation to its claims", collect,
                               view, templates::traceability}};
}  // namespace
}  // namespace reports::traceability_section
