#pragma once

#include "verification/framework/source.h"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace verification {

/// What a measured value must satisfy, and why: a bound that nobody can explain, nobody can trust.
struct Bound {
    double low, high;
    std::string why;
    bool holds(double measured) const { return low <= measured && measured <= high; }  // NaN: no
};
inline Bound at_most(double high, std::string why) { return {-HUGE_VAL, high, std::move(why)}; }
inline Bound at_least(double low, std::string why) { return {low, HUGE_VAL, std::move(why)}; }
inline Bound between(double low, double high, std::string why) {
    return {low, high, std::move(why)};
}

/// One sentence of a paper (or of ours) that a computer can check.
struct Claim {
    std::string id;  // subject.claim; never reused, it is the row key of every report
    Source source;
    std::string says;
    Bound bound;
    std::function<double()> measure;
    /// The same measurement on a variant that is wrong on purpose: it must break the bound.
    std::function<double()> sabotaged = {};
    /// Number of the erratum (see Erratum) whose printed form the sabotaged variant is.
    std::optional<int> erratum = {};
    std::vector<std::string> tags = {};  // the part of the id before the dot is always a tag
};

/// A formula or statement that the text has wrong. The claims that name it measure the corrected
/// form and, as their sabotaged variant, the printed form: both numbers stand in the errata table.
struct Erratum {
    int number;
    Source source;
    std::string printed;
    std::string corrected;
};

class Mutant;

enum class Verdict {
    verified,
    failed,
    toothless,                // the bound lets the sabotaged variant pass
    saturated,                // a study: the error stops falling at a floor
    not_in_asymptotic_range,  // a study: no order can be told from these levels
    inconclusive              // the interval of the measurement straddles the bound
};
std::string_view name_of(Verdict verdict);

struct ClaimResult {
    Claim claim;
    Verdict verdict;
    double measured;  // NaN if the measurement threw; then `error` says why
    std::optional<double> sabotaged;
    double seconds;
    std::string error;
    std::vector<Mutant*> depends_on = {};  // those whose operators `claim.measure` called
};

/// Measures `claim` and its sabotaged variant. Never throws: what a measurement throws is its error.
/// Not to be called by two threads at once.
ClaimResult measure(const Claim& claim);

}  // namespace verification
