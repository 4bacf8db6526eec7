#pragma once

#include "reports/charts/chart.h"
#include "verification/framework/study.h"

namespace reports {

/// Error over spacing of every series, with the spread over the seeds as bars and a triangle for each
/// order that is expected.
Chart chart_of(const verification::StudyResult& result);

/// The id as the name of a file, without an extension.
std::string file_name_of(const verification::Study& study);

}  // namespace reports
