#pragma once

#include "reports/charts/chart.h"

namespace reports {

/// The ellipse that holds 95 % of a normal spread with the covariance of log x and log y, as a closed
/// outline in x and y: z = mean + √(−2 ln 0.05) L u for unit vectors u, with L Lᵀ the covariance; the
/// root is the quantile of χ with 2 degrees of freedom. Needs two points or more, all positive.
Chart::Outline spread_ellipse(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace reports
