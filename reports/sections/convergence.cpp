#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/study_pieces.h"
#include "reports/words.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>

namespace reports::convergence_section {
namespace {
using namespace verification;

constexpr double seconds_per_study = 3600.0;

void measure_studies(ReportRun& run) {
    run.report["studies"] = run_studies(studies(), run.quick ? Effort::quick : Effort::full,
                                        seconds_per_study, run.pieces);
}

std::string interval(const Json& ends) {
    return fmt::format("[{}, {}]", short_number(ends[0]), short_number(ends[1]));
}

Json row_of(const Json& series) {
    const std::string verdict = series["verdict"];
    return {{"name", series["name"].get<std::string>() +
                         (series.value("sabotaged", false) ? " (wrong on purpose)" : "")},
            {"expected", series["expected_saturation"].get<bool>()
                             ? "to saturate"
                             : bound_in_words(series["expected"])},
            {"why", series["expected"]["why"]},
            {"order", short_number(series["order"])},
            {"confidence", interval(series["confidence"])},
            {"floor", short_number(series["floor"])},
            {"gci", short_number(series["grid_convergence_index"])},
            {"failures", series.value("failures", 0)},
            {"verdict", verdict},
            {"class", colour_class(verdict)}};
}

Json view(const Json& report) {
    if (report.value("studies", Json::array()).empty()) return nullptr;
    Json rows = Json::array();
    for (const Json& study : report["studies"]) {
        Json row = {{"id", study["id"]},
                    {"says", study["says"]},
                    {"quantity", study["quantity"]},
                    {"error", study.value("error", "")},
                    {"warning", study.value("warning", "")},
                    {"source", study["source"]["paper"].get<std::string>() + " " +
                                   study["source"]["place"].get<std::string>()},
                    {"seeds", counted(study["seeds"].get<std::size_t>(), "seed")},
                    {"levels", counted(study["spacing"].size(), "level")},
                    {"series", Json::array()}};
        for (const Json& series : study["series"]) row["series"].push_back(row_of(series));
        if (study.contains("chart")) row["chart"] = study["chart"];
        rows.push_back(std::move(row));
    }
    return {{"studies", rows}};
}

const RegisterSection section{{40, "convergence", "Does the error fall as theory says?",
                               measure_studies, view, templates::convergence}};
}  // namespace
}  // namespace reports::convergence_section
