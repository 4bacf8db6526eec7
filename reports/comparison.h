#pragma once

#include "reports/json.h"

#include <string>
#include <vector>

namespace reports {

/// What became of one claim, one series of a study, or one time.
struct Change {
    enum class Verdict { worse, better, cannot_tell, same };
    Verdict verdict;
    std::string id;           // "claims/poly6.is_smooth", "studies/ID/SERIES", "times/…"
    std::string before, now;  // what was found
    std::string why;
};
std::string_view name_of(Change::Verdict verdict);
Json json_of(const Change& change);

/// All that two results of `verify`, `converge`, `neighbours`, `frontier` or `report` have in common,
/// the worse first. What only one of them has cannot be told.
/// - A claim, and a series of a study, is better or worse when its verdict is; a series of the same
///   verdict when the 95 % intervals of the orders are apart.
/// - A time is better or worse when the medians differ by more than both noise floors and three times
///   their combined deviation (1.4826 MAD each); it cannot be told if less, if a file has no noise
///   floor, or if the processors or the numbers of threads differ.
/// Throws InvalidInput if a file is not a result of Plumbline.
std::vector<Change> compare(const Json& before, const Json& now);

}  // namespace reports
