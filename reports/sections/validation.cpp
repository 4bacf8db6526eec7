#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/validation_report.h"
#include "reports/words.h"

#include <fmt/format.h>

namespace reports::validation_section {
namespace {
using namespace verification;

void measure_validations(ReportRun& run) {
    run.report["validations"] =
        run_validations(validations(), run.quick ? Effort::quick : Effort::full, run.pieces);
    for (const Json& validation : run.report["validations"])
        run.report["findings_right"].push_back(
            fmt::format("Against experiment, {}: {}.", validation["id"].get<std::string>(),
                        validation["finding"].get<std::string>()));
}

Json row_of(const Json& q) {
    const std::string unit = q["unit"];
    return {{"name", q["name"]},
            {"levels", in_words(q["simulated"])},
            {"measured", with_uncertainty(q["measured"], q["u_data"], unit)},
            {"error", with_uncertainty(q["error"], q["u_val"], unit)},
            {"parts", fmt::format("u_num {}, u_input {}, u_D {}", short_number(q["u_num"]),
                                  short_number(q["u_input"]), short_number(q["u_data"]))},
            {"why", q["why"]},
            {"verdict", q["verdict"]},
            {"class", q["verdict"] == "agrees" ? "ok" : "open"},
            {"goal", q["goal"]},
            {"goal_why", q["goal_why"]}};
}

Json view(const Json& report) {
    if (report.value("validations", Json::array()).empty()) return nullptr;
    Json rows = Json::array();
    for (const Json& v : report["validations"]) {
        Json row = {{"id", v["id"]},
                    {"finding", v["finding"]},
                    {"says", v["says"]},
                    {"what_is_run", v["what_is_run"]},
                    {"spacing", in_words(v["spacing"])},
                    {"source", v["source"]["place"]},
                    {"quantities", Json::array()},
                    {"panels", v["panels"]}};
        for (const Json& q : v["quantities"]) row["quantities"].push_back(row_of(q));
        row["has_quantities"] = !row["quantities"].empty();
        rows.push_back(std::move(row));
    }
    return {{"validations", rows}};
}

const RegisterSection section{{55, "validation", "Do fluids move as experiments say?",
                               measure_validations, view, templates::validation}};
}  // namespace
}  // namespace reports::validation_section
