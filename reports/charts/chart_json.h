#pragma once

#include "reports/charts/chart.h"
#include "reports/json.h"

namespace reports {

/// Everything that `draw` needs, so that a stored report can be drawn again; `name` is that of the
/// files.
Json json_of(const Chart& chart, const std::string& name);

/// The chart that json_of described.
Chart chart_from(const Json& json);

}  // namespace reports
