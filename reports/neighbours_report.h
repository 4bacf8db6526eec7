#pragma once

#include "benchmarks/neighbours/studies.h"
#include "reports/json.h"

namespace reports {

/// What one run of the comparison of the neighbour searches measured.
struct NeighbourComparison {
    std::vector<benchmarks::SearchStudyResult> studies;
    std::string command;  // makes it again
};

Json json_of(const benchmarks::SearchResult& result);
Json json_of(const benchmarks::CaseResult& result);
/// With exponents, verdicts and the maps of who is the fastest.
Json json_of(const benchmarks::SearchStudyResult& study);
Json json_of(const NeighbourComparison& comparison);

/// The table twin of everything measured: one row per study, case and search.
std::string csv_of(const NeighbourComparison& comparison);

/// "graded 3D, 10000 points 1:100, r = 2 spacings, shuffled, 2 threads".
std::string in_words(const benchmarks::CaseResult& c);

}  // namespace reports
