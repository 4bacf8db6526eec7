#include "reports/commands/kernel.h"
#include "solver/foundation/errors.h"
#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

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

TEST_CASE("anisotropic_table is the kernel seen through a map, of the same integral") {
    // G = ((2, 1), (0, 1)) takes (x, y) to (2 x + y, y); |det G| = 2.
    const std::vector<double> map{2, 1, 0, 1}, at{0.1, 0.2};
    const auto rows = reports::anisotropic_table("poly6", 2, 1.0, map, at);
    REQUIRE(rows.size() == 1);
    const double r = std::hypot(0.4, 0.2);
    const auto radial = kernel_table("poly6", 2, 1.0, {r})[0];
    CHECK(rows[0].value == Approx(2.0 * radial.value).epsilon(1e-14));
    const double slope = radial.derivative / r;  // the gradient is 2 Gᵀ (0.4, 0.2) ω′/r
    CHECK(rows[0].gradient[0] == Approx(2.0 * slope * 0.8).epsilon(1e-14));
    CHECK(rows[0].gradient[1] == Approx(2.0 * slope * 0.6).epsilon(1e-14));
    const auto value = [&](double x, double y) {
        return reports::anisotropic_table("poly6", 2, 1.0, map, {x, y})[0].value;
    };
    constexpr double step = 1e-4;  // f‴′ step² / 12 is some 1e-6 of it
    const double differences =
        (value(0.1 + step, 0.2) + value(0.1 - step, 0.2) + value(0.1, 0.2 + step) +
         value(0.1, 0.2 - step) - 4.0 * value(0.1, 0.2)) /
        (step * step);
    CHECK(rows[0].laplacian == Approx(differences).epsilon(1e-4));
}

TEST_CASE("anisotropic_table refuses matrices and points that are none") {
    using reports::anisotropic_table;
    CHECK_THROWS_MATCHES(anisotropic_table("poly6", 2, 1, {1, 0, 0}, {0, 0}), InvalidInput,
                         Message("--map: expected 4 numbers, found 3"));
    CHECK_THROWS_MATCHES(anisotropic_table("poly6", 3, 1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0}),
                         InvalidInput,
                         Message("--at: expected 3 numbers for each point, found 2 in all"));
    CHECK_THROWS_MATCHES(anisotropic_table("poly6", 1, 1, {1}, {0}), InvalidInput,
                         Message("--map: expected a dimension of 2 or 3, found 1"));
    CHECK_THROWS_AS(anisotropic_table("poly6", 2, 1, {1, 1, 1, 1}, {0, 0}), InvalidInput);
    CHECK_THROWS_AS(anisotropic_table("poly6", 2, 1, {1, 0, 0, 1}, {0, HUGE_VAL}), InvalidInput);
}

TEST_CASE(
    "plumbline kernel: JSON has a schema, where it comes from, and a word for what is infinite") {
    const verification::ScratchFolder folder;
    const auto run =
        run_plumbline(folder, {"kernel", "singular", "--support", "2", "--at", "0,1", "--json"});
    REQUIRE(run.exit_code == 0);
    const auto json = nlohmann::json::parse(run.out);
    CHECK(json.at("schema") == "plumbline.kernel/1");
    CHECK(json.at("provenance").contains("version"));
    const auto& rows = json.at("kernel").at("rows");
    CHECK(rows.at(0).at("value") == "inf");
    CHECK(rows.at(1).at("value").get<double>() == kernel_table("singular", 2, 2.0, {1.0})[0].value);
    const auto list =
        nlohmann::json::parse(run_plumbline(folder, {"kernel", "--list", "--json"}).out);
    CHECK(list.at("schema") == "plumbline.kernels/1");
    CHECK(list.at("kernels").at("names").size() >= 11);
    const auto seen =
        run_plumbline(folder, {"kernel", "poly6", "--map", "2,0,0,1", "--at", "0,0", "--json"});
    CHECK(nlohmann::json::parse(seen.out).at("kernel").at("rows").at(0).at("value").get<double>() ==
          Approx(2.0 * kernel_table("poly6", 2, 1.0, {0.0})[0].value));
}

}  // namespace kernel_command_test
