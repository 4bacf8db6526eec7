#include "solver/foundation/random.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace random_test {
namespace {
using plumbline::Random;

TEST_CASE("Random is the engine that the C++ standard specifies bit for bit") {
    Random random(5489);  // the default seed of mt19937_64
    std::uint64_t bits = 0;
    for (int k = 0; k < 10000; ++k) bits = random.bits();
    CHECK(bits == 9981545732273789042u);  // C++20 [rand.predef]: its 10000th value
}

TEST_CASE("Random::uniform has the mean 1/2 and the variance 1/12, and stays below 1") {
    Random random(1);
    const int n = 100000;
    double mean = 0.0, square = 0.0, largest = 0.0, smallest = 1.0;
    for (int k = 0; k < n; ++k) {
        const double u = random.uniform();
        mean += u / n;
        square += u * u / n;
        largest = std::max(largest, u);
        smallest = std::min(smallest, u);
    }
    const double five_sigma = 5.0 / std::sqrt(12.0 * n);
    CHECK(std::abs(mean - 0.5) < five_sigma);
    // E u⁴ − (E u²)² = 1/5 − 1/9 = 4/45.
    CHECK(std::abs(square - 1.0 / 3.0) < 5.0 * std::sqrt(4.0 / 45.0 / n));
    CHECK(largest < 1.0);
    CHECK(smallest >= 0.0);
}

TEST_CASE("Random::uniform of a range stays in it") {
    Random random(2);
    for (int k = 0; k < 1000; ++k) {
        const double u = random.uniform(-3.0, -1.0);
        CHECK((u >= -3.0 && u < -1.0));
    }
}
}  // namespace
}  // namespace random_test
