#pragma once

#include "reports/interrupt.h"
#include "reports/json.h"
#include "reports/progress.h"
#include "reports/watchdog.h"
#include "verification/framework/registry.h"

#include <type_traits>
#include <vector>

namespace reports {

/// The result of `measure_one` for each entry, one after the other, with progress; Ctrl-C ends it with
/// Interrupted, and an entry that crashes or takes longer than `seconds_each` ends the program, named.
template <class Entry, class Measure>
auto one_by_one(const std::vector<Entry>& entries, double seconds_each, Measure measure_one) {
    std::vector<std::invoke_result_t<Measure, const Entry&>> results;
    Progress progress(entries.size());
    Watchdog watchdog(seconds_each);
    for (const Entry& entry : entries) {
        stop_if_interrupted();
        progress.step(entry.id);
        watchdog.watch(entry.id);
        results.push_back(measure_one(entry));
    }
    return results;
}

/// Measures the claims one after the other, with progress; Ctrl-C ends it with Interrupted, and a
/// claim that crashes or takes longer than `seconds_per_claim` ends the program, named.
std::vector<verification::ClaimResult> measure_all(const std::vector<verification::Claim>& claims,
                                                   double seconds_per_claim);

/// Whether everything that `verdict` says of its claim or series is in its favour.
bool passed(verification::Verdict verdict);

/// One erratum, and the claims that name it: their sabotaged variant is the printed form.
struct ErratumResult {
    verification::Erratum erratum;
    std::vector<verification::ClaimResult> claims;
    bool caught() const;
};
std::vector<ErratumResult> errata_in(const std::vector<verification::ClaimResult>& results);

/// One row of the matrix of mutants and claims.
struct MutantRow {
    struct Cell {
        std::string claim;
        verification::MutantResult result;
    };
    const verification::Mutant* mutant;
    std::vector<Cell> cells;  // the claims on the operator, by their ids
    std::size_t caught() const;
};
/// A claim, and the mutants of the operators that it calls.
struct Dependent {
    std::string id;
    const verification::Claim* claim;
    std::vector<verification::Mutant*> on;
};
std::vector<Dependent> dependents(const std::vector<verification::ClaimResult>& results);
/// Of results as json_of(ClaimResult) gives them, of claims that are registered.
std::vector<Dependent> dependents(const Json& results);

/// Every mutant in the place of its operator, for each of the claims that depend on it.
std::vector<MutantRow> measure_mutants(const std::vector<Dependent>& claims,
                                       double seconds_per_claim);
Json json_of(const MutantRow& row);

}  // namespace reports
