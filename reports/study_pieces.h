#pragma once

#include "reports/json.h"
#include "reports/pieces.h"

#include <vector>

namespace reports {

/// The studies as json_of(StudyResult) gives them, each with its "chart" as json_of(Chart) gives it
/// unless it has an "error". Those that `pieces` holds are not run again.
Json run_studies(const std::vector<verification::Study>& studies, verification::Effort effort,
                 double seconds_per_study, Pieces& pieces);

}  // namespace reports
