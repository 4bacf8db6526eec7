#include "reports/measurements.h"

#include <algorithm>
#include <stdexcept>

namespace reports {

using namespace verification;

namespace {
template <class Entry, class Key>
auto named(const std::vector<Entry>& entries, Key key, const std::string& name) {
    const auto found = std::ranges::find(entries, name, key);
    if (found == entries.end()) throw std::runtime_error("not registered: " + name);
    return found;
}
}  // namespace

std::vector<ClaimResult> measure_all(const std::vector<Claim>& claims, double seconds_per_claim) {
    return one_by_one(claims, seconds_per_claim, measure);
}

bool passed(Verdict verdict) { return verdict == Verdict::verified; }

bool ErratumResult::caught() const {
    return std::ranges::any_of(claims, [](const ClaimResult& r) {
        return r.sabotaged && !r.claim.bound.holds(*r.sabotaged);
    });
}

std::vector<ErratumResult> errata_in(const std::vector<ClaimResult>& results) {
    std::vector<ErratumResult> all;
    for (const Erratum& erratum : errata()) {
        ErratumResult one{erratum, {}};
        for (const ClaimResult& r : results)
            if (r.claim.erratum == erratum.number) one.claims.push_back(r);
        all.push_back(std::move(one));
    }
    return all;
}

std::size_t MutantRow::caught() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(cells, [](const Cell& c) { return c.result.caught; }));
}

std::vector<Dependent> dependents(const std::vector<ClaimResult>& results) {
    std::vector<Dependent> all;
    for (const ClaimResult& r : results)
        if (!r.depends_on.empty()) all.push_back({r.claim.id, &r.claim, r.depends_on});
    return all;
}

std::vector<Dependent> dependents(const Json& results) {
    std::vector<Dependent> all;
    for (const Json& r : results) {
        if (!r.contains("depends_on")) continue;
        const Claim& claim = *named(claims(), &Claim::id, r["id"]);
        all.push_back({claim.id, &claim, {}});
        for (const Json& name : r["depends_on"])
            all.back().on.push_back(*named(mutants(), &Mutant::printed, name));
    }
    return all;
}

std::vector<MutantRow> measure_mutants(const std::vector<Dependent>& claims,
                                       double seconds_per_claim) {
    std::vector<MutantRow> rows;
    for (const Mutant* mutant : mutants()) rows.push_back({mutant, {}});
    const auto by_claim = one_by_one(claims, seconds_per_claim, [](const Dependent& d) {
        return measure_with_mutants(*d.claim, d.on);
    });
    for (std::size_t k = 0; k < claims.size(); ++k)
        for (const MutantResult& result : by_claim[k])
            std::ranges::find(rows, result.mutant, &MutantRow::mutant)
                ->cells.push_back({claims[k].id, result});
    return rows;
}

Json json_of(const MutantRow& row) {
    Json cells = Json::array();
    for (const MutantRow::Cell& c : row.cells)
        cells.push_back({{"id", c.claim},
                         {"measured", number(c.result.measured)},
                         {"caught", c.result.caught}});
    return {{"erratum", row.mutant->erratum},
            {"printed", row.mutant->printed},
            {"replaces", row.mutant->replaces},
            {"claims", std::move(cells)}};
}

}  // namespace reports
