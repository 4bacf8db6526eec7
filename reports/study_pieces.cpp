#include "reports/study_pieces.h"

#include "reports/charts/chart_json.h"
#include "reports/charts/study_chart.h"
#include "reports/measurements.h"

namespace reports {

using namespace verification;

namespace {
Json piece_of(const Study& study, Effort effort) {
    const StudyResult result = run(study, effort);
    Json piece = json_of(result);
    if (result.error.empty()) piece["chart"] = json_of(chart_of(result), file_name_of(study));
    return piece;
}
}  // namespace

Json run_studies(const std::vector<Study>& studies, Effort effort, double seconds_per_study,
                 Pieces& pieces) {
    return one_by_one(studies, seconds_per_study, [&](const Study& study) {
        return pieces.get("studies/" + study.id, [&] { return piece_of(study, effort); });
    });
}

}  // namespace reports
