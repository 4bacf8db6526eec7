#include "reports/approximation/point_values.h"
#include "solver/foundation/errors.h"
#include "verification/reports/program.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace approximate_test {

using namespace reports;
using plumbline::InvalidInput;
using plumbline::parse_points;

namespace {
double field(double x, double y) { return 1 + 2 * x - 3 * y + x * y; }

/// f on a disturbed grid of 11 × 11 points with spacing 0.1; in the plane z = 0.3 if `planar`.
std::string grid(bool planar = false) {
    std::string text = planar ? "x,y,z,f\n" : "x,y,f\n";
    for (int i = 0; i < 11; ++i)
        for (int j = 0; j < 11; ++j) {
            const double x = 0.1 * i + 0.01 * std::sin(3 * i + j), y = 0.1 * j + 0.01 * std::cos(i);
            text += planar ? fmt::format("{},{},0.3,{}\n", x, y, field(x, y))
                           : fmt::format("{},{},{}\n", x, y, field(x, y));
        }
    return text;
}

std::vector<PointValue> values(const std::string& samples, const std::string& at,
                               const std::string& method, double support = 0.28,
                               const std::string& kernel = "poly6") {
    const auto sample_file = parse_points("samples.csv", samples);
    const auto at_file = parse_points("at.csv", at);
    return approximate(
        {sample_file, at_file, "f", std::nullopt, parse_method(method), kernel, support});
}
}  // namespace

TEST_CASE("approximate: mls of order 2 gives a quadratic field and its derivatives") {
    const auto found = values(grid(), "x,y\n0.5,0.52\n", "mls:2");
    REQUIRE(found.size() == 1);
    CHECK(found[0].status == "ok");
    CHECK(found[0].value.value() == Approx(field(0.5, 0.52)).epsilon(1e-12));
    CHECK(found[0].gradient[0] == Approx(2.52).epsilon(1e-12));
    CHECK(found[0].gradient[1] == Approx(-2.5).epsilon(1e-12));
    CHECK(std::abs(found[0].laplacian.value()) < 1e-10);
}

TEST_CASE("approximate: a Laplacian from order 2 on, that of the order in use") {
    const auto only = [](const char* method, const std::string& samples) {
        CAPTURE(method);
        return values(samples, "x,y\n0.5,0.52\n", method).at(0);
    };
    for (const char* method : {"shepard", "mls:0", "mls:1", "mlsph:0", "mlsph:1"}) {
        const PointValue found = only(method, grid());
        CHECK(found.status == "no_laplacian");
        CHECK(!found.laplacian);
        CHECK(found.value);
        CHECK(found.gradient.size() == 2);
    }
    for (const char* method : {"sph", "mls:2", "mls:3", "mlsph:2", "mlsph:3"}) {
        const PointValue found = only(method, grid());
        CHECK(found.status == "ok");
        CHECK(found.laplacian);
    }
    const PointValue fallen = only("mlsph:2", "x,y,f\n0.5,0.5,1\n0.6,0.5,2\n0.5,0.6,3\n");
    CHECK(fallen.status == "reduced_order:1");
    CHECK(fallen.gradient[0] == Approx(10.0));
    CHECK(!fallen.laplacian);
}

TEST_CASE("approximate: shepard interpolates with a singular kernel") {
    const std::string samples = "x,y,f\n0,0,1\n0.1,0,2\n0,0.2,5\n";
    const auto found = values(samples, "x,y\n0.1,0\n0.05,0\n9,9\n", "shepard", 0.15, "singular");
    CHECK(found[0].value == 2.0);
    CHECK(found[0].gradient.empty());
    CHECK(!found[0].laplacian);
    CHECK(found[0].status == "no_gradient");
    CHECK(found[1].value.value() == Approx(1.5));
    CHECK(found[1].gradient.size() == 2);
    CHECK(found[1].status == "no_laplacian");
    CHECK(found[2].status == "no_neighbours");
    CHECK_THROWS_WITH(values(samples, "x,y\n0.1,0\n", "sph", 0.15, "singular"),
                      Catch::Contains("\"singular\"") && Catch::Contains("infinite"));
}

TEST_CASE("approximate: every method says so where no sample is near") {
    for (const char* method : {"sph", "shepard", "mls:0", "mls:3", "mlsph:1", "mueller"}) {
        CAPTURE(method);
        const auto found = values(grid(), "x,y\n0.5,0.5\n9,9\n", method);
        CHECK(found[1].status == "no_neighbours");
        CHECK(!found[1].value);
        CHECK(found[1].gradient.empty());
        CHECK(!found[1].laplacian);
    }
}

TEST_CASE("approximate: samples that lie in a plane lower the rank, which is stated") {
    const auto mls = values(grid(true), "x,y,z\n0.5,0.5,0.3\n", "mls:1");
    CHECK(mls[0].status == "rank_deficient:3");
    CHECK(std::abs(mls[0].gradient[2]) < 1e-11);
    CHECK(values(grid(true), "x,y,z\n0.5,0.5,0.4\n", "mlsph:1")[0].status == "reduced_order:0");
    CHECK(values("x,y,f\n0,0,1\n", "x,y\n0.1,0\n", "mls:1")[0].status == "rank_deficient:1");
}

TEST_CASE("approximate: mueller answers at samples only") {
    const std::string samples = "x,y,f\n0,0,1\n0.1,0,2\n0,0.1,3\n0.3,0,1\n0.3,0,2\n0.35,0,1\n";
    const auto found = values(samples, "x,y\n0,0\n0.01,0\n0.3,0\n0.35,0\n", "mueller", 0.15);
    CHECK(found[0].status == "ok");
    CHECK(found[0].value == 1.0);
    CHECK(found[0].gradient[0] == Approx(10.0));
    CHECK(found[0].gradient[1] == Approx(20.0));
    CHECK(!found[0].laplacian);
    CHECK(found[1].status == "not_a_sample");
    CHECK(found[2].status == "repeated_sample");
    CHECK(found[3].status == "rank_deficient:2");
}

TEST_CASE("approximate: bad input is refused with a reason") {
    const std::string at = "x,y\n0.5,0.5\n";
    for (const char* method : {"", "mls", "mls:", "mls:4", "mls:-1", "mls:1.5", "mlsph:x", "MLS:1"})
        CHECK_THROWS_AS(parse_method(method), InvalidInput);
    for (const double support : {0.0, -1.0, HUGE_VAL, std::nan("")})
        CHECK_THROWS_AS(values(grid(), at, "sph", support), InvalidInput);
    CHECK_THROWS_AS(values(grid(), "x,y,z\n0.5,0.5,0\n", "sph"), InvalidInput);
    CHECK_THROWS_AS(values("x,y\n0,0\n", at, "sph"), InvalidInput);
    CHECK_THROWS_AS(values("x,y,f\n0,0,nan\n", at, "sph"), InvalidInput);
}

TEST_CASE("plumbline approximate: JSON has a schema, where it comes from, and null for no number") {
    const verification::ScratchFolder folder;
    folder.write("samples.csv", grid());
    folder.write("at.csv", "x,y\n0.5,0.52\n9,9\n");
    const auto run = run_plumbline(
        folder, {"approximate", "--samples", "samples.csv", "--at", "at.csv", "--method", "mls:2",
                 "--kernel", "poly6", "--support", "0.28", "--json", "out.json"});
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.starts_with("x,y,value,d_x,d_y,laplacian,status\n"));
    const auto json = nlohmann::json::parse(folder.read("out.json"));
    CHECK(json.at("schema") == "plumbline.approximate/1");
    CHECK(
        json.at("provenance").at("command_line").get<std::string>().starts_with("plumbline appr"));
    const auto& result = json.at("approximate");
    CHECK(result.at("method") == "mls:2");
    CHECK(result.at("points").at(0).at("value").get<double>() == Approx(field(0.5, 0.52)));
    CHECK(result.at("points").at(1).at("status") == "no_neighbours");
    CHECK(result.at("points").at(1).at("value").is_null());
}

TEST_CASE("approximate: every method that is listed has its own name, and is read") {
    for (const NamedMethod& known : methods()) {
        CHECK(parse_method(known.name).family == known.method.family);
        CHECK(parse_method(known.name).order == known.method.order);
        CHECK_FALSE(known.says.empty());
    }
    CHECK(methods().size() == 11);  // sph, shepard, mueller and two families of four orders
}

}  // namespace approximate_test
