#pragma once

#include "verification/framework/registry.h"

#include <vector>

namespace reports {

/// Measures the claims one after the other, with progress; Ctrl-C ends it with Interrupted, and a
/// claim that crashes or takes longer than `seconds_per_claim` ends the program, named.
std::vector<verification::ClaimResult> measure_all(const std::vector<verification::Claim>& claims,
                                                   double seconds_per_claim);

/// The same for studies.
std::vector<verification::StudyResult> run_all(const std::vector<verification::Study>& studies,
                                               verification::Effort effort,
                                               double seconds_per_study);

/// Whether everything that `verdict` says of its claim or series is in its favour.
bool passed(verification::Verdict verdict);

/// One erratum and the claims that catch its printed form.
struct Mutant {
    verification::Erratum erratum;
    std::vector<verification::ClaimResult> claims;  // those that name it
    bool caught() const;
};
std::vector<Mutant> mutants(const std::vector<verification::ClaimResult>& results);

}  // namespace reports
