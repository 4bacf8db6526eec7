#pragma once

#include "reports/neighbours_series.h"

namespace reports {

/// Who is the fastest to build and query, and by what margin, over density contrast and number of points.
Chart contrast_map(const NeighbourCases& cases);

/// Who is the fastest to update and query, over the queries per update and the share of moved points.
Chart moved_map(const NeighbourCases& cases);

}  // namespace reports
