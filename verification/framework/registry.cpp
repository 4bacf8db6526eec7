#include "verification/framework/registry.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace verification {

namespace {
// Filled by static initialisers of many files, hence created at first use.
template <class Entry> std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
}

std::string as_text(const std::string& id) { return id; }
std::string as_text(int number) { return "erratum " + std::to_string(number); }

template <class Entry, class Key> std::vector<Entry> sorted(Key key) {
    std::vector<Entry> all = entries<Entry>();
    std::ranges::stable_sort(all, {}, key);
    const auto twice = std::ranges::adjacent_find(all, {}, key);
    if (twice != all.end())
        throw std::logic_error("registered twice: " + as_text(std::invoke(key, *twice)));
    return all;
}
}  // namespace

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = sorted<Claim>(&Claim::id);
    return all;
}
const std::vector<Study>& studies() {
    static const std::vector<Study> all = sorted<Study>(&Study::id);
    return all;
}
const std::vector<Erratum>& errata() {
    static const std::vector<Erratum> all = sorted<Erratum>(&Erratum::number);
    return all;
}

const std::vector<Mutant*>& mutants() {
    static const std::vector<Mutant*> all = [] {
        std::vector<Mutant*> sorted = entries<Mutant*>();
        std::ranges::sort(sorted, {},
                          [](const Mutant* m) { return std::pair(m->erratum, m->printed); });
        return sorted;
    }();
    return all;
}

void Register::add(Claim claim) {
    claim.tags.push_back(claim.id.substr(0, claim.id.find('.')));
    entries<Claim>().push_back(std::move(claim));
}
void Register::add(Study study) {
    study.tags.push_back(study.id.substr(0, study.id.find('.')));
    entries<Study>().push_back(std::move(study));
}
void Register::add(Erratum erratum) { entries<Erratum>().push_back(std::move(erratum)); }
void Register::add(Mutant* mutant) { entries<Mutant*>().push_back(mutant); }

}  // namespace verification
