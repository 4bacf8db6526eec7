#include "verification/framework/traceability.h"

#include <catch2/catch.hpp>

#include <set>

namespace traceability_test {

using namespace verification;

TEST_CASE("every statement of the covered parts has a claim") {
    for (const Statement& statement : statements()) {
        INFO(name_of(statement.paper) << " " << statement.item << ": " << statement.says);
        CHECK_FALSE(claims_of(statement).empty());
    }
}

TEST_CASE("a statement that no text makes has no claim") {
    CHECK(claims_of({Paper::adams2009, "Eq. 1000", "not there"}).empty());
}

TEST_CASE("statements are listed once") {
    std::set<std::string_view> items;
    for (const Statement& statement : statements()) CHECK(items.insert(statement.item).second);
}

TEST_CASE("every erratum that a claim names is registered, and none is without a claim") {
    std::set<int> registered, named;
    for (const Erratum& erratum : errata()) registered.insert(erratum.number);
    for (const Claim& claim : claims())
        if (claim.erratum) named.insert(*claim.erratum);
    CHECK(registered == named);
}

}  // namespace traceability_test
