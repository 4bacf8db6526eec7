#pragma once

#include "verification/framework/claim.h"
#include "verification/framework/mutant.h"
#include "verification/framework/study.h"

#include <vector>

namespace verification {

/// Everything registered, in the order of the ids (of the numbers for errata and their mutants).
/// Throws std::logic_error if two entries share an id.
const std::vector<Claim>& claims();
const std::vector<Study>& studies();
const std::vector<Erratum>& errata();
const std::vector<Mutant*>& mutants();

/// `const Register r{Claim{...}, Study{...}, Erratum{...}, &mutant};` in a verification file; there is no
/// list elsewhere.
struct Register {
    template <class... Entries> explicit Register(Entries... entries) {
        (add(std::move(entries)), ...);
    }
    /// For families of claims made in a loop: Register{std::vector<Claim>{...}}.
    template <class Entry> explicit Register(std::vector<Entry> entries) {
        for (Entry& entry : entries) add(std::move(entry));
    }

private:
    static void add(Claim claim);
    static void add(Study study);
    static void add(Erratum erratum);
    static void add(Mutant* mutant);
};

}  // namespace verification
