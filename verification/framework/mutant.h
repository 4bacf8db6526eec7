#pragma once

#include "verification/framework/claim.h"

#include <atomic>

namespace verification {

/// An operator of the solver as the text prints it, wrong as that is. Claims call the operator through
/// a seam, a function or type of verification/ that takes the printed form while the mutant is
/// applied, and the solver's otherwise:
///     return eq_19_with_minus.applied() ? as_printed(…) : gradient_symmetric(…);
/// So each claim that depends on the operator can be measured with the mutant in its place. There is
/// one object of each, `inline constinit` in the header of its seam, and it is registered where the
/// erratum is.
class Mutant {
public:
    constexpr Mutant(int number, std::string_view as_printed, std::string_view what)
        : erratum{number}, printed{as_printed}, replaces{what} {}

    const int erratum;                // number of the Erratum that it belongs to
    const std::string_view printed;   // "Eq. 92 without its exponent"; its name, too
    const std::string_view replaces;  // the operator: "spiky, ω in 3D"

    /// To be asked at the seam: whether the printed form is to be taken.
    bool applied() const {
        if (!asked_.load(std::memory_order_relaxed)) asked_.store(true, std::memory_order_relaxed);
        return applied_.load(std::memory_order_relaxed);
    }

private:
    friend struct Experiment;
    mutable std::atomic<bool> asked_ = false;
    std::atomic<bool> applied_ = false;
};

/// What one claim measures with one mutant in the place of an operator that the claim depends on.
struct MutantResult {
    const Mutant* mutant;
    double measured;  // NaN if the measurement threw
    bool caught;      // it is out of the claim's bound
};

/// The mutants whose seams `measurement` passes. Not to be called by two threads at once.
std::vector<Mutant*> mutants_asked_by(const std::function<void()>& measurement);

/// Measures `claim` with each of the mutants that it depends on, one at a time. Not to be called by two
/// threads at once.
std::vector<MutantResult> measure_with_mutants(const Claim& claim,
                                               const std::vector<Mutant*>& depends_on);

}  // namespace verification
