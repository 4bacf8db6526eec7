#include "reports/measurements.h"

#include <algorithm>

namespace reports {

using namespace verification;

std::vector<ClaimResult> measure_all(const std::vector<Claim>& claims, double seconds_per_claim) {
    return one_by_one(claims, seconds_per_claim, measure);
}

bool passed(Verdict verdict) { return verdict == Verdict::verified; }

bool Mutant::caught() const {
    return std::ranges::any_of(claims, [](const ClaimResult& r) {
        return r.sabotaged && !r.claim.bound.holds(*r.sabotaged);
    });
}

std::vector<Mutant> mutants(const std::vector<ClaimResult>& results) {
    std::vector<Mutant> all;
    for (const Erratum& erratum : errata()) {
        Mutant mutant{erratum, {}};
        for (const ClaimResult& r : results)
            if (r.claim.erratum == erratum.number) mutant.claims.push_back(r);
        all.push_back(std::move(mutant));
    }
    return all;
}

}  // namespace reports
