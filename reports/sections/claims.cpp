#include "reports/measurements.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"
#include "verification/framework/registry.h"

#include <algorithm>
#include <map>

namespace reports::claims_section {
namespace {
constexpr double seconds_per_claim = 120.0;

void measure_claims(ReportRun& run) {
    run.report["claims"] =
        one_by_one(verification::claims(), seconds_per_claim, [&](const verification::Claim& c) {
            return run.pieces.get("claims/" + c.id, [&] { return json_of(measure(c)); });
        });
}

std::string place_of(const Json& source) {
    return source.at("paper").get<std::string>() + " " + source.at("place").get<std::string>();
}

Json row_of(const Json& claim) {
    Json row = {{"id", claim["id"]},
                {"source", place_of(claim["source"])},
                {"says", claim["says"]},
                {"measured", short_number(claim["measured"])},
                {"bound", bound_in_words(claim["bound"])},
                {"why", claim["bound"]["why"]},
                {"verdict", claim["verdict"]},
                {"class", colour_class(claim["verdict"])},
                {"error", claim.value("error", "")}};
    if (!claim["sabotaged"].is_null())
        row["sabotaged"] = {{"measured", short_number(claim["sabotaged"]["measured"])},
                            {"word", claim["sabotaged"]["caught"] ? "refused" : "PASSED"}};
    return row;
}

Json view_of_claims(const Json& report) {
    if (report.value("claims", Json::array()).empty()) return nullptr;
    std::map<std::string, Json> by_subject;
    Json broken = Json::array();
    for (const Json& claim : report["claims"]) {
        const std::string id = claim["id"];
        Json& rows = by_subject[id.substr(0, id.find('.'))];
        rows.push_back(row_of(claim));
        if (claim["verdict"] != "verified") broken.push_back(rows.back());
    }
    Json groups = Json::array();
    for (const auto& [subject, rows] : by_subject) {
        const std::size_t good = count_verdict(rows, "verified");
        groups.push_back({{"subject", subject},
                          {"good", good},
                          {"all", rows.size()},
                          {"class", good == rows.size() ? "ok" : "bad"},
                          {"rows", rows}});
    }
    return {{"total", report["claims"].size()},
            {"broken", broken},
            {"any_broken", !broken.empty()},
            {"groups", groups}};
}

const RegisterSection section{
    {70, "claims", "Every claim", measure_claims, view_of_claims, templates::claims}};
}  // namespace
}  // namespace reports::claims_section
