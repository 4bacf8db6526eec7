#pragma once

#include "benchmarks/scenes/fluid_frontier.h"
#include "reports/charts/chart.h"
#include "reports/json.h"

namespace reports {

Json json_of(const benchmarks::FluidFrontier& frontier);

/// Error against time, a series per method and kernel, with the Pareto front.
Chart chart_of(const benchmarks::FluidFrontier& frontier);

/// All candidates, one per row, with a header; "failure" is empty where there was none.
std::string csv_of(const benchmarks::FluidFrontier& frontier);

}  // namespace reports
