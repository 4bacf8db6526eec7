#include "solver/scene/pass.h"

#include <catch2/catch.hpp>

namespace pass_test {
namespace {
using namespace plumbline;
struct A {
    int value = 0;
};
struct B {
    int value = 0;
};
struct AddOneToA {
    using Reads = Quantities<>;
    using Writes = Quantities<A>;
    void run(double, A& a) const { ++a.value; }
};
struct DoubleAIntoB {
    using Reads = Quantities<A>;
    using Writes = Quantities<B>;
    void run(double, const A& a, B& b) const { b.value = 2 * a.value; }
};

TEST_CASE("passes run once each, in their order") {
    A a;
    B b;
    const Arguments<Quantities<>, A, B> at(a, b);
    run_passes(std::tuple{AddOneToA{}, AddOneToA{}, DoubleAIntoB{}, AddOneToA{}}, 0.1, at);
    CHECK(a.value == 3);
    CHECK(b.value == 4);
}

TEST_CASE("passes read from outside what none of them writes") {
    STATIC_REQUIRE(std::is_same_v<ReadFromOutside<DoubleAIntoB>, Quantities<A>>);
    STATIC_REQUIRE(std::is_same_v<ReadFromOutside<AddOneToA, DoubleAIntoB>, Quantities<>>);
}
}  // namespace
}  // namespace pass_test
