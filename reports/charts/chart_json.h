#pragma once

#include "reports/charts/chart.h"
#include "reports/json.h"

namespace reports {

/// Everything that `draw` needs, so that a stored report can be drawn again; `name` is that of the
/// files. Numbers that are not finite become null.
Json json_of(const Chart& chart, const std::string& name);

/// The chart that json_of described; null becomes NaN.
Chart chart_from(const Json& json);

}  // namespace reports
