#pragma once

#include "benchmarks/neighbours/studies.h"
#include "reports/frontier_report.h"

namespace reports {

/// The charts that suit what differs between the cases of a study: the rate and the memory over the
/// number of points; a map of the fastest over contrast and number, and over moved share and queries per
/// update; the time over a radius, an order, a kind of cloud, a number of threads; and build against
/// query time of the largest case, with the spread of the rounds.
std::vector<NamedChart> charts_of(const benchmarks::SearchStudyResult& study,
                                  const std::string& command);

}  // namespace reports
