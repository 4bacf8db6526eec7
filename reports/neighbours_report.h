#pragma once

#include "benchmarks/neighbours/comparison.h"
#include "reports/frontier_report.h"

namespace reports {

/// The cases of one cloud, at one or more numbers of points.
struct NeighbourComparison {
    std::vector<benchmarks::CaseResult> cases;
    std::string command;  // makes it again
};

Json json_of(const benchmarks::SearchResult& result);
Json json_of(const benchmarks::CaseResult& result);
Json json_of(const NeighbourComparison& comparison);

/// The table twin of everything measured: one row per case and search.
std::string csv_of(const NeighbourComparison& comparison);

/// Million points per second over the number of points; build against query time of the largest case.
std::vector<NamedChart> charts_of(const NeighbourComparison& comparison);

}  // namespace reports
