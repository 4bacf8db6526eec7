#include "verification/framework/oracle.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

namespace oracle_test {

using namespace verification;

TEST_CASE("ulp_error counts units in the last place of the exact value") {
    CHECK(ulp_error(1.0, 1) == 0.0);
    CHECK(ulp_error(1.0 + 0x1p-52, 1) == 1.0);
    CHECK(ulp_error(-8.0, Real50(-8) - Real50(0x1p-50)) == Approx(0.5));
    CHECK(ulp_error(0.1, Real50(1) / 10) < 0.5);
    CHECK(ulp_error(0.0, 0) == 0.0);
}

TEST_CASE("integrate is exact to rounding for kinks at breakpoints and singular ends") {
    CHECK(std::abs(integrate([](double x) { return std::abs(x - 0.3); }, 0, 1, {0.3}) - 0.29) <
          1e-15);
    CHECK(std::abs(integrate([](double x) { return 1 / std::sqrt(x); }, 0, 1) - 2.0) < 1e-13);
    CHECK(std::abs(integrate([](double x) { return x * x * x; }, -1, 1)) < 1e-16);
    CHECK_THROWS_AS(integrate([](double x) { return 1 / x; }, 0, 1), std::runtime_error);
}

TEST_CASE("integrate_polynomial is exact to 48 digits up to degree 59") {
    const Real50 exact = Real50(1) / 60;
    const Real50 found = integrate_polynomial([](const Real50& x) { return pow(x, 59); }, 0, 1);
    CHECK(abs(found - exact).convert_to<double>() < 1e-48);
}

}  // namespace oracle_test
