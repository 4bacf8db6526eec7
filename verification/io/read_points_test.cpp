#include "solver/io/read_points.h"

#include <catch2/catch.hpp>

namespace read_points_test {
namespace {
using namespace plumbline;
using namespace std::string_literals;

using Numbers = std::vector<double>;

void check(const PointFile& points, int dim, const Numbers& coordinates) {
    CHECK(points.dim == dim);
    CHECK(points.coordinates == coordinates);
}
std::string big_endian(std::initializer_list<const char*> bytes) {
    std::string joined;
    for (const char* b : bytes) joined += std::string(b, 4);
    return joined;
}
const std::string vtp_head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"";
const std::string piece = "<PolyData><Piece NumberOfPoints=\"1\"><Points>";
const std::string tail = "</Points></Piece></PolyData>";
}  // namespace

TEST_CASE("points: CSV with columns in any order, comments, CR LF, a byte order mark", "[io]") {
    const PointFile points = parse_points(
        "a.csv", "\xEF\xBB\xBF# made by hand\r\nf,y,\"x\",m\r\n7,2,1,9\r\n\r\n8,4,+3,10");
    check(points, 2, {1, 2, 3, 4});
    CHECK(points.column("f") == Numbers{7, 8});
    CHECK(points.column("m") == Numbers{9, 10});
    CHECK(points.find("g") == nullptr);
    CHECK_THROWS_WITH(points.column("g"), "expected a column \"g\", found only: f, m");
}

TEST_CASE("points: as a type of fixed dimension", "[io]") {
    const PointFile points = parse_points("a.csv", "x,y,z\n1,2,3\n4,5,6\n");
    CHECK(points.points_as<3>() == Points<3>{{1, 2, 3}, {4, 5, 6}});
    CHECK_THROWS_WITH(points.points_as<2>(), "expected points in 2D, found points in 3D");
}

TEST_CASE("points: the first bytes tell the format, then the extension, then the first line",
          "[io]") {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
        "y\nend_header\n1 2\n";
    check(parse_points("wrongly_named.csv", ply), 2, {1, 2});
    check(parse_points("no_extension", "x,y\n1,2\n"), 2, {1, 2});
    check(parse_points("no_extension", "1 2 3\n"), 3, {1, 2, 3});
    check(parse_points("capitals.CSV", "x,y\n1,2\n"), 2, {1, 2});
}

TEST_CASE("points: XYZ with further columns, and that of a molecule", "[io]") {
    const PointFile points = parse_points("a.xyz", "# cloud\n1 2 3 0.5\n\n4\t5  6 0.25\n");
    check(points, 3, {1, 2, 3, 4, 5, 6});
    CHECK(points.column("column_4") == Numbers{0.5, 0.25});
    check(parse_points("a.xyz", "2\nhydrogen\nH 0 0 0\nH 0.74 0 0\n"), 3, {0, 0, 0, 0.74, 0, 0});
    check(parse_points("a.xyz", "2\n\n0 0 0\n1 0 0\n"), 3, {0, 0, 0, 1, 0, 0});
}

TEST_CASE("points: PLY with other elements and lists, and by its bytes in big endian", "[io]") {
    const PointFile points = parse_points("a.ply",
                                          "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement camera "
                                          "1\r\nproperty list uchar int ids\r\n"
                                          "element vertex 2\r\nproperty double x\r\nproperty list "
                                          "uchar float w\r\nproperty double y\r\n"
                                          "property int id\r\nelement face 1\r\nproperty list "
                                          "uchar int vertex_indices\r\nend_header\r\n"
                                          "2 8 9\r\n0.5 1 77 1.5 4\r\n2.5 0 3.5 5\r\n3 0 1 1\r\n");
    check(points, 2, {0.5, 1.5, 2.5, 3.5});
    CHECK(points.column("id") == Numbers{4, 5});

    // 1.0f, −2.0f, 0.5f and the short 258, as IEEE 754 writes them.
    const std::string binary =
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property short s\nend_header\n" +
        big_endian({"\x3F\x80\0\0", "\xC0\0\0\0", "\x3F\0\0\0"}) + "\x01\x02";
    check(parse_points("a.ply", binary), 3, {1.0, -2.0, 0.5});
    CHECK(parse_points("a.ply", binary).column("s") == Numbers{258});
}

TEST_CASE("points: VTP, appended raw and base64, narrow and wide lengths", "[io]") {
    const std::string xyz = big_endian({"\x3F\x80\0\0", "\xC0\0\0\0", "\x3F\0\0\0"});
    const std::string array =
        "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" "
        "format=\"appended\" offset=\"3\"/>";
    check(parse_points("a.vtp", vtp_head + "BigEndian\">" + piece + array + tail +
                                    "<AppendedData encoding=\"raw\">\n_abc" + "\0\0\0\x0C"s + xyz +
                                    "</AppendedData></VTKFile>"),
          3, {1.0, -2.0, 0.5});
    // The same twelve bytes behind a length of eight, by the table of RFC 4648.
    const std::string wide = "AAAAAAAAAAw/gAAAwAAAAD8AAAA=";
    const std::string inline_array =
        "<DataArray type=\"Float32\" format=\"binary\">\n " + wide + "\n</DataArray>";
    check(parse_points("a.vtp", vtp_head + "BigEndian\" header_type=\"UInt64\">" + piece +
                                    inline_array + tail + "</VTKFile>"),
          3, {1.0, -2.0, 0.5});
    const std::string at_4 = "<DataArray type=\"Float32\" format=\"appended\" offset=\"4\"/>";
    check(parse_points("a.vtp", vtp_head + "BigEndian\" header_type=\"UInt64\">" + piece + at_4 +
                                    tail + "<AppendedData encoding=\"base64\">_AAAA" + wide +
                                    "AAAA</AppendedData></VTKFile>"),
          3, {1.0, -2.0, 0.5});
}

TEST_CASE("points: VTP in the plane, vectors by component, names with entities", "[io]") {
    const PointFile points = parse_points(
        "a.vtp",
        "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"2\"><PointData>"
        "<DataArray Name=\"v\" NumberOfComponents=\"2\">1 2 3 4</DataArray>"
        "<DataArray Name=\"a&lt;b\">5\n6</DataArray><DataArray Name=\"label\" type=\"String\"/>"
        "</PointData><Points><DataArray>0 1 0 2 3 "
        "0</DataArray></Points></Piece></PolyData></VTKFile>");
    check(points, 2, {0, 1, 2, 3});
    CHECK(points.column("v_0") == Numbers{1, 3});
    CHECK(points.column("v_1") == Numbers{2, 4});
    CHECK(points.column("a<b") == Numbers{5, 6});
}

}  // namespace read_points_test
