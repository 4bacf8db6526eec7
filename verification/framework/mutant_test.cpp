#include "verification/framework/mutant.h"

#include "verification/framework/registry.h"

#include <catch2/catch.hpp>

#include <set>

namespace mutant_test {
namespace {
using namespace verification;

constinit Mutant twice{0, "2x", "x"};
const Register registered{&twice};
double x() { return twice.applied() ? 2.0 : 1.0; }

Claim claim_of(std::function<double()> measure) {
    return {.id = "mutant_test.claim",
            .source = {Paper::plumbline, "docstring of Mutant"},
            .says = "x = 1",
            .bound = between(1.0, 1.0, "by definition"),
            .measure = std::move(measure)};
}

std::vector<MutantResult> with_mutants(const Claim& claim) {
    return measure_with_mutants(claim, measure(claim).depends_on);
}
}  // namespace

TEST_CASE("a claim that passes the seam is measured with the mutant, which is then taken out") {
    const auto results = with_mutants(claim_of(x));
    REQUIRE(results.size() == 1);
    CHECK(results[0].mutant == &twice);
    CHECK(results[0].measured == 2.0);
    CHECK(results[0].caught);
    CHECK(x() == 1.0);
}

TEST_CASE("a claim that cannot see a mutant on its way lets it pass") {
    const auto results = with_mutants(claim_of([] { return x() / x(); }));
    REQUIRE(results.size() == 1);
    CHECK_FALSE(results[0].caught);
}

TEST_CASE("a claim that does not depend on an operator is not measured with its mutants") {
    CHECK(with_mutants(claim_of([] { return 1.0; })).empty());
}

TEST_CASE("a mutant that throws is caught, and taken out all the same") {
    const auto results = with_mutants(
        claim_of([] { return x() == 1.0 ? 1.0 : throw std::runtime_error("no bucket"); }));
    REQUIRE(results.size() == 1);
    CHECK(results[0].caught);
    CHECK(std::isnan(results[0].measured));
    CHECK(x() == 1.0);
}

TEST_CASE("an operator that only the sabotaged variant calls is not what a claim depends on") {
    Claim claim = claim_of([] { return 1.0; });
    claim.sabotaged = [] { return 1.0 + x(); };
    CHECK(measure(claim).depends_on.empty());
}

TEST_CASE("every mutant belongs to an erratum, and has a name of its own") {
    std::set<int> numbers{twice.erratum};
    for (const Erratum& erratum : errata()) numbers.insert(erratum.number);
    std::set<std::string_view> names;
    for (const Mutant* mutant : mutants()) {
        INFO(mutant->printed);
        CHECK(numbers.contains(mutant->erratum));
        CHECK(names.insert(mutant->printed).second);
    }
}

}  // namespace mutant_test
