#pragma once

#include "reports/charts/chart.h"
#include "reports/json.h"
#include "reports/pieces.h"
#include "verification/framework/validation.h"

namespace reports {

/// With a "chart" for each panel.
Json json_of(const verification::ValidationResult& result);

/// The measured signal and its band, and the signals of the three finest levels.
Chart chart_of(const verification::ValidationResult& result, std::size_t panel);

/// Each validation that has levels of this effort, one level after the other, the levels kept as pieces.
Json run_validations(const std::vector<verification::Validation>& validations,
                     verification::Effort effort, Pieces& pieces);

/// "0.0651 ± 0.015 1/s".
std::string with_uncertainty(const Json& value, const Json& uncertainty, const std::string& unit);

}  // namespace reports
