#include "reports/measurements.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"
#include "verification/framework/registry.h"

#include <algorithm>

namespace reports::errata_section {
namespace {
/// The errata, each with the claims of the report that measure its printed and its corrected form.
constexpr double seconds_per_claim = 120.0;

void collect(ReportRun& run) {
    run.report["mutants"] = run.piece("mutants", "claims with printed formulas", [&] {
        return json_array(measure_mutants(dependents(run.report["claims"]), seconds_per_claim));
    });
    run.report["errata"] = Json::array();
    for (const verification::Erratum& erratum : verification::errata()) {
        Json row = json_of(erratum);
        row["caught"] = false;
        row["claims"] = Json::array();
        for (const Json& claim : run.report["claims"]) {
            if (claim.value("erratum", 0) != erratum.number || claim["sabotaged"].is_null())
                continue;
            row["claims"].push_back({{"id", claim["id"]},
                                     {"printed", claim["sabotaged"]["measured"]},
                                     {"corrected", claim["measured"]},
                                     {"caught", claim["sabotaged"]["caught"]}});
            if (claim["sabotaged"]["caught"]) row["caught"] = true;
        }
        run.report["errata"].push_back(std::move(row));
    }
}

Json view(const Json& report) {
    if (report.value("errata", Json::array()).empty()) return nullptr;
    Json rows = Json::array();
    for (Json row : report["errata"]) {
        row["where"] = row["source"]["paper"].get<std::string>() + " " +
                       row["source"]["place"].get<std::string>();
        row["class"] = row["caught"] ? "ok" : "bad";
        row["word"] = row["caught"] ? "caught" : "NOT caught";
        for (Json& claim : row["claims"]) {
            claim["printed_value"] = short_number(claim["printed"]);
            claim["corrected_value"] = short_number(claim["corrected"]);
        }
        rows.push_back(std::move(row));
    }
    Json mutants = Json::array();
    for (Json row : report.value("mutants", Json::array())) {
        const auto caught = std::ranges::count_if(
            row["claims"], [](const Json& claim) { return claim["caught"].get<bool>(); });
        row["caught"] = caught;
        row["all"] = row["claims"].size();
        row["class"] = caught > 0 ? "ok" : "bad";
        for (Json& claim : row["claims"]) {
            claim["class"] = claim["caught"] ? "ok" : "open";
            claim["value"] = short_number(claim["measured"]);
        }
        mutants.push_back(std::move(row));
    }
    return {{"rows", rows}, {"mutants", mutants}};
}

const RegisterSection section{{90, "errata", "What the text and other sources have wrong, measured",
                               collect, view, templates::errata}};
}  // namespace
}  // namespace reports::errata_section
