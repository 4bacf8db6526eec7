#include "solver/foundation/quantities.h"

#include <catch2/catch.hpp>

namespace quantities_test {
namespace {
using namespace plumbline;
struct A {};
struct B {};
struct C {};

TEST_CASE("a union lists each quantity once, in the order of first appearance") {
    STATIC_REQUIRE(std::is_same_v<Union<Quantities<B, A>, Quantities<A, C>, Quantities<B>>,
                                  Quantities<B, A, C>>);
    STATIC_REQUIRE(std::is_same_v<Union<Quantities<A, A>>, Quantities<A>>);
    STATIC_REQUIRE(std::is_same_v<Union<>, Quantities<>>);
}

TEST_CASE("a difference keeps what the second list lacks") {
    STATIC_REQUIRE(
        std::is_same_v<Difference<Quantities<A, B, C>, Quantities<B>>, Quantities<A, C>>);
    STATIC_REQUIRE(std::is_same_v<Difference<Quantities<A>, Quantities<A>>, Quantities<>>);
    STATIC_REQUIRE(contains<Quantities<A, B>, B>);
    STATIC_REQUIRE(!contains<Quantities<A, B>, C>);
}
}  // namespace
}  // namespace quantities_test
