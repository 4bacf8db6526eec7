#include "solver/io/poly_data.h"

#include "solver/io/read_points.h"
#include "verification/io/xml_check_test.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

namespace poly_data_test {
namespace {
using namespace plumbline;
using namespace verification;

std::string vtp(const PolyData& data, VtpEncoding encoding) {
    std::ostringstream out;
    write_vtp(out, data, encoding);
    return std::move(out).str();
}

TEST_CASE("particles are read back bit for bit, whatever the encoding") {
    const PolyData data{
        .xyz = {0.1, 0.2, 0.3, -0.0, 5e-324, 1e300},
        .arrays = {{"velocity", 3, {1, 2, 3, 4, 5, 1.0 / 3.0}}, {"pressure", 1, {0.1, -7}}}};
    for (const auto encoding : {VtpEncoding::ascii, VtpEncoding::base64}) {
        const ScratchFolder folder;
        folder.write("p.vtp", vtp(data, encoding));
        CHECK(is_well_formed(folder, "p.vtp"));
        const PointFile read = read_points(folder.path() / "p.vtp");
        CHECK(read.coordinates == data.xyz);
        CHECK(read.column("pressure") == std::vector<double>{0.1, -7});
        CHECK(read.column("velocity_2") == std::vector<double>{3, 1.0 / 3.0});
    }
}

TEST_CASE("cells are counted as points, lines and polygons") {
    PolyData data{.xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0}, .arrays = {}};
    CHECK(vtp(data, VtpEncoding::ascii).find("NumberOfPoints=\"3\" NumberOfVerts=\"3\"") !=
          std::string::npos);
    data.kind = PolyData::Cells::triangles, data.corners = {0, 1, 2};
    CHECK(vtp(data, VtpEncoding::ascii).find("NumberOfPolys=\"1\"") != std::string::npos);
    data.kind = PolyData::Cells::edges, data.corners = {0, 1, 1, 2};
    const std::string lines = vtp(data, VtpEncoding::ascii);
    CHECK(lines.find("NumberOfLines=\"2\"") != std::string::npos);
    CHECK(lines.find("\n2\n4\n</DataArray>\n</Lines>") != std::string::npos);
}

TEST_CASE("arrays of another length, and corners that are no points, are refused") {
    std::ostringstream out;
    CHECK_THROWS_WITH(write_vtp(out, {.xyz = {0, 0, 0}, .arrays = {{"f", 1, {1, 2}}}}),
                      Catch::Contains("f: expected 1 values, found 2"));
    CHECK_THROWS_WITH(write_vtp(out, {.xyz = {0, 0, 0},
                                      .arrays = {},
                                      .kind = PolyData::Cells::triangles,
                                      .corners = {0, 0, 1}}),
                      Catch::Contains("corners below 1, found 1"));
}

TEST_CASE("vectors of the plane get a third component") {
    CHECK(in_space(std::vector<double>{1, 2, 3, 4}, 2) == std::vector<double>{1, 2, 0, 3, 4, 0});
    CHECK(in_space(std::vector<double>{1, 2, 3}, 3) == std::vector<double>{1, 2, 3});
}
}  // namespace
}  // namespace poly_data_test
