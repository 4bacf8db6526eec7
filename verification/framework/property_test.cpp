#include "verification/framework/property.h"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

namespace property_test {

using namespace verification;

TEST_CASE("counterexamples is 0 for a true property and 1 for a false one") {
    CHECK(counterexamples([] { RC_ASSERT(uniform(1.0, 2.0) >= 1.0); }) == 0.0);
    CHECK(counterexamples([] { RC_ASSERT(uniform(1.0, 2.0) < 1.9); }) == 1.0);
    CHECK(counterexamples([] { throw std::runtime_error("no answer"); }) == 1.0);
    CHECK_THROWS_AS(counterexamples([] { RC_PRE(false); }), std::logic_error);
}

TEST_CASE("a property draws the same cases on every run, as many as it was told") {
    const auto draw = [] {
        std::vector<double> drawn;
        counterexamples([&] { drawn.push_back((point<3>(-1.0, 1.0)).norm()); }, {.number = 50});
        return drawn;
    };
    CHECK(draw().size() == 50);
    CHECK(draw() == draw());
}

TEST_CASE("uniform fills its range in small cases too, and shrinks to its low end") {
    double low = 1.0, high = 0.0;
    counterexamples(
        [&] {
            const double x = uniform(0.0, 1.0);
            low = std::min(low, x), high = std::max(high, x);
        },
        {.number = 20});
    CHECK(low < 0.3);
    CHECK(high > 0.7);
    CHECK(counterexample([] { RC_ASSERT(uniform(2.0, 3.0) < 0.0); }).find("double 2") !=
          std::string::npos);
}

TEST_CASE("worst_error is the largest of all cases, and NaN if one of them is NaN") {
    CHECK(worst_error([] { return -uniform(0.0, 1.0); }) > 0.9);
    CHECK(std::isnan(worst_error([] { return std::log(uniform(-1.0, 0.0)); })));
}

}  // namespace property_test
