#include "verification/framework/claim.h"

#include "verification/framework/mutant.h"

#include <chrono>
#include <exception>
#include <limits>

namespace verification {

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::verified:
            return "verified";
        case Verdict::failed:
            return "failed";
        case Verdict::toothless:
            return "toothless";
        case Verdict::saturated:
            return "saturated";
        case Verdict::not_in_asymptotic_range:
            return "not in asymptotic range";
        case Verdict::inconclusive:
            return "inconclusive";
    }
    return "";
}

ClaimResult measure(const Claim& claim) {
    const auto start = std::chrono::steady_clock::now();
    ClaimResult result{claim, Verdict::failed, std::numeric_limits<double>::quiet_NaN(), {}, 0, {},
                       {}};
    try {
        result.depends_on = mutants_asked_by([&] { result.measured = claim.measure(); });
        if (claim.sabotaged) result.sabotaged = claim.sabotaged();
        const bool caught = !result.sabotaged || !claim.bound.holds(*result.sabotaged);
        if (claim.bound.holds(result.measured))
            result.verdict = caught ? Verdict::verified : Verdict::toothless;
    } catch (const std::exception& e) {
        result.error = e.what();
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace verification
