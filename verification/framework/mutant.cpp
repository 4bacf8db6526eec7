#include "verification/framework/mutant.h"

#include "verification/framework/registry.h"

#include <exception>
#include <limits>

namespace verification {

/// The only one who may apply a mutant; it is taken out again whatever happens.
struct Experiment {
    explicit Experiment(Mutant& mutant) : mutant_{mutant} { mutant_.applied_ = true; }
    ~Experiment() { mutant_.applied_ = false; }
    Experiment(const Experiment&) = delete;
    Experiment& operator=(const Experiment&) = delete;

    static void forget_who_was_asked() {
        for (const Mutant* mutant : mutants()) mutant->asked_ = false;
    }
    static bool was_asked(const Mutant& mutant) { return mutant.asked_; }

private:
    Mutant& mutant_;
};

namespace {
double measured(const Claim& claim) {
    try {
        return claim.measure();
    } catch (const std::exception&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}
}  // namespace

std::vector<Mutant*> mutants_asked_by(const std::function<void()>& measurement) {
    Experiment::forget_who_was_asked();
    measurement();
    std::vector<Mutant*> asked;
    for (Mutant* mutant : mutants())
        if (Experiment::was_asked(*mutant)) asked.push_back(mutant);
    return asked;
}

std::vector<MutantResult> measure_with_mutants(const Claim& claim,
                                               const std::vector<Mutant*>& depends_on) {
    // What the claim keeps from its first run on has to come from the solver's own operators.
    if (!depends_on.empty()) measured(claim);
    std::vector<MutantResult> results;
    for (Mutant* mutant : depends_on) {
        const Experiment experiment(*mutant);
        const double value = measured(claim);
        results.push_back({mutant, value, !claim.bound.holds(value)});
    }
    return results;
}

}  // namespace verification
