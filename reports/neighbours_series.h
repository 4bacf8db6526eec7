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
