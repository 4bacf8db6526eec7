#pragma once

#include "benchmarks/neighbours/findings.h"
#include "reports/charts/chart.h"

#include <functional>
#include <optional>

namespace reports {

using NeighbourCases = std::vector<benchmarks::CaseResult>;

/// The case with the most points, the first of them.
const benchmarks::CaseResult& largest(const NeighbourCases& cases);

/// A median and its 95 % interval; the whole range where there are too few rounds for one.
struct Estimate {
    double value;
    Chart::Range range;
};
Estimate estimate(const std::vector<double>& values);
Estimate exactly(double value);

std::vector<double> nanoseconds_per_point(std::vector<double> seconds,
                                          const benchmarks::CaseResult& c);

/// "cell_grid is the fastest in 7 of 9, by 1.5x to 2.2x; in 2 of 9 the fastest cannot be told".
std::string wins_in_words(const std::vector<benchmarks::Standing>& standings);
std::string wins_in_words(const NeighbourCases& cases);

/// The part of a caption that says what the numbers are.
std::string how_measured(const benchmarks::CaseResult& c);

/// Adds one series per search; each case that `at` gives a place is a point of it.
struct Place {
    Estimate x, y;
};
using At = std::function<std::optional<Place>(const benchmarks::CaseResult&,
                                              const benchmarks::SearchResult&)>;
void add_searches(const NeighbourCases& cases, Chart& chart, const At& at);

}  // namespace reports
