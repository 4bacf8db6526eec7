#pragma once

#include "benchmarks/approximation/frontier.h"
#include "reports/charts/chart.h"
#include "reports/json.h"

namespace reports {

/// The word of the command line: approximation, gradient, laplacian.
std::string task_of(verification::Quantity quantity);
/// Throws InvalidInput, naming the tasks there are, if `task` is none.
verification::Quantity quantity_of(const std::string& task);

/// "ok", or what is missing.
std::string status_of(const benchmarks::Candidate& candidate);
/// A number of evaluations in two figures, or "never".
std::string evaluations(double count);

Json json_of(const benchmarks::Candidate& candidate);
Json json_of(const benchmarks::PrecomputedRatio& ratio);
Json json_of(const benchmarks::Frontier& frontier);

/// "gradient_2d": what tells it from other frontiers, also in names of files.
std::string name_of(const benchmarks::Frontier& frontier);

/// A chart and the name of its files.
struct NamedChart {
    std::string name;
    Chart chart;
};
/// Error against the time for all samples of the unit box, with the Pareto front; and error
/// against the time per place, evaluated anew and with shape functions computed once.
std::vector<NamedChart> charts_of(const benchmarks::Frontier& frontier);

/// All candidates of a frontier as json_of gives it, one per row, with its keys as the header: medians of
/// times in seconds, empty where there is none.
std::string candidates_csv(const Json& frontier);

}  // namespace reports
