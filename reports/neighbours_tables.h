#pragma once

#include "benchmarks/neighbours/studies.h"

#include <string>

namespace reports {

/// What a person reads on a terminal: a table per case with the places that can be told, then how the
/// times grow and the verdicts, where the study has them.
std::string table_of(const benchmarks::CaseResult& result);
std::string tables_of(const benchmarks::SearchStudyResult& study);

}  // namespace reports
