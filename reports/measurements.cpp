#include "reports/measurements.h"

#include "reports/interrupt.h"
#include "reports/progress.h"
#include "reports/watchdog.h"

#include <algorithm>

namespace reports {

using namespace verification;

namespace {
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
}  // namespace

std::vector<ClaimResult> measure_all(const std::vector<Claim>& claims, double seconds_per_claim) {
    return one_by_one(claims, seconds_per_claim, measure);
}

std::vector<StudyResult> run_all(const std::vector<Study>& studies, Effort effort,
                                 double seconds_per_study) {
    return one_by_one(studies, seconds_per_study,
                      [effort](const Study& study) { return run(study, effort); });
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
