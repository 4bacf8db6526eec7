#pragma once

#include "reports/json.h"

namespace reports {

/// The strip at the head of the page: [{"label", "value", "word", "class"}], counted in the report.
Json tiles_of(const Json& report);

/// The three questions of Plumbline with the answers that the report gives: [{"question", "points"}].
/// A question for which the report has no result yet is left out.
Json answers_of(const Json& report);

}  // namespace reports
