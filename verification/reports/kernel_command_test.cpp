#include "reports/commands/kernel.h"
#include "solver/foundation/errors.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace kernel_command_test {

using Catch::Matchers::Message;
using plumbline::InvalidInput;
using reports::kernel_table;
using reports::numbers_of;

TEST_CASE("kernel_table gives a kernel and its derivatives at the radii asked for") {
    const auto rows = kernel_table("poly6", 2, 2.0, {0.0, 1.0, 2.0, 3.0});
    REQUIRE(rows.size() == 4);
    const double sigma = 4.0 / M_PI / 4.0;  // Eqs. 89-91 at h = 2
    CHECK(rows[0].value == Approx(sigma).epsilon(1e-15));
    CHECK(rows[0].derivative == 0.0);
    CHECK(rows[0].laplacian == Approx(-12.0 * sigma / 4.0).epsilon(1e-15));
    CHECK(rows[1].value == Approx(sigma * std::pow(0.75, 3)).epsilon(1e-15));
    CHECK(rows[1].derivative == Approx(-3.0 * sigma * std::pow(0.75, 2) / 2.0).epsilon(1e-15));
    CHECK(rows[1].second_derivative == Approx(6.0 * sigma * 0.75 * 0.25 / 4.0).epsilon(1e-15));
    for (const auto& row : {rows[2], rows[3]})
        for (const double v : {row.value, row.derivative, row.second_derivative, row.laplacian}) {
            CHECK(v == 0.0);
            CHECK_FALSE(std::signbit(v));
        }
}

TEST_CASE("kernel_table refuses what no kernel can answer, and says what it expected") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_MATCHES(
        kernel_table("poly7", 1, 1, {0}), InvalidInput,
        Message("no kernel \"poly7\" in 1D; expected one of: cubic_spline gaussian lucy poly6 "
                "quintic_spline spiky wendland_c2 wendland_c4 wendland_c6"));
    CHECK_THROWS_MATCHES(kernel_table("poly6", 4, 1, {0}), InvalidInput,
                         Message("--dim: expected 1, 2 or 3, found 4"));
    CHECK_THROWS_MATCHES(kernel_table("poly6", 2, 1, {-0.5}), InvalidInput,
                         Message("--at: expected radii r >= 0, found -0.5"));
    CHECK_THROWS_AS(kernel_table("poly6", 2, 1, {nan}), InvalidInput);
    CHECK_THROWS_MATCHES(kernel_table("poly6", 2, 0, {0}), InvalidInput,
                         Message("poly6: expected a support radius from 1e-50 to 1e+50, found 0"));
    for (const double support : {-1.0, nan, HUGE_VAL, 1e-60, 1e60})
        CHECK_THROWS_AS(kernel_table("spiky", 3, support, {0}), InvalidInput);
}

TEST_CASE("numbers_of reads a list, and says which item is no number") {
    CHECK(numbers_of("0,0.5,1e-3") == std::vector<double>{0, 0.5, 1e-3});
    CHECK_THROWS_MATCHES(numbers_of("0.1,abc"), InvalidInput,
                         Message("--at: expected numbers r1,r2,..., found \"abc\" as number 2"));
    for (const char* wrong : {"", ",", "1,", "1,,2", "1;2", "0x", "1.5m", " 1"})
        CHECK_THROWS_AS(numbers_of(wrong), InvalidInput);
}

}  // namespace kernel_command_test
