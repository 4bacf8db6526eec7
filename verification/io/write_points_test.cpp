#include "solver/io/write_points.h"
#include "solver/foundation/random.h"
#include "solver/io/read_points.h"

#include <catch2/catch.hpp>

#include <bit>
#include <limits>
#include <sstream>

namespace write_points_test {
namespace {
using namespace plumbline;

using Write = void (*)(std::ostream&, const PointFile&);
struct Format {
    const char* name;
    Write write;
};
const Format formats[] = {
    {"points.csv", [](std::ostream& out, const PointFile& p) { write_points_csv(out, p); }},
    {"ascii.ply",
     [](std::ostream& out, const PointFile& p) { write_points_ply(out, p, PlyEncoding::ascii); }},
    {"little.ply",
     [](std::ostream& out, const PointFile& p) {
         write_points_ply(out, p, PlyEncoding::little_endian);
     }},
    {"big.ply", [](std::ostream& out,
                   const PointFile& p) { write_points_ply(out, p, PlyEncoding::big_endian); }},
    {"ascii.vtp",
     [](std::ostream& out, const PointFile& p) { write_points_vtp(out, p, VtpEncoding::ascii); }},
    {"base64.vtp",
     [](std::ostream& out, const PointFile& p) { write_points_vtp(out, p, VtpEncoding::base64); }},
};

/// Any finite double: subnormal, huge, negative zero.
double any_finite(Random& random) {
    for (;;) {
        const double value = std::bit_cast<double>(random.bits());
        if (std::isfinite(value)) return value;
    }
}

PointFile awkward_points(int dim, std::size_t n) {
    Random random(7);
    PointFile points{dim, {}, {{"f", {}}, {"mass", {}}}};
    for (std::size_t k = 0; k < n * static_cast<std::size_t>(dim); ++k)
        points.coordinates.push_back(any_finite(random));
    for (PointColumn& c : points.columns)
        for (std::size_t i = 0; i < n; ++i) c.values.push_back(any_finite(random));
    points.coordinates[0] = -0.0;
    points.coordinates[1] = std::numeric_limits<double>::denorm_min();
    points.columns[0].values[0] = std::numeric_limits<double>::max();
    return points;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, {}, std::bit_cast<std::uint64_t, double>,
                              std::bit_cast<std::uint64_t, double>);
}
}  // namespace

TEST_CASE("points come back from every format with the same bits", "[io]") {
    for (const int dim : {2, 3})
        for (const std::size_t n : {1, 2, 3, 500})
            for (const Format& format : formats) {
                INFO(format.name << ", " << dim << "D, n = " << n);
                const PointFile written = awkward_points(dim, n);
                std::ostringstream out;
                format.write(out, written);
                const PointFile read = parse_points(format.name, out.str());
                CHECK(read.dim == dim);
                CHECK(same_bits(read.coordinates, written.coordinates));
                REQUIRE(read.columns.size() == 2);
                CHECK(read.columns[0].name == "f");
                CHECK(same_bits(read.column("f"), written.columns[0].values));
                CHECK(same_bits(read.column("mass"), written.columns[1].values));
            }
}

TEST_CASE("columns that no file could give back are refused", "[io]") {
    using Column = PointColumn;
    const auto message = [](const Column& column, const Format& format) -> std::string {
        std::ostringstream out;
        try {
            format.write(out, {2, {0, 1, 2, 3}, {{"f", {4, 5}}, column}});
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return "accepted";
    };
    const std::string own = "expected a name of its own for each column, found ";
    for (const Format& format : formats) {
        CHECK(message({"g", {1}}, format) ==
              "column \"g\": expected 2 values, one per point, found 1");
        CHECK(message({"", {1, 2}}, format) == own + "\"\"");
        CHECK(message({"f", {1, 2}}, format) == own + "\"f\" twice");
        CHECK(message({"y", {1, 2}}, format) == own + "\"y\" twice");
    }
    CHECK(message({"a b", {1, 2}}, formats[1]) ==
          "a PLY file: expected a name without blanks, found \"a b\"");
}

}  // namespace write_points_test
