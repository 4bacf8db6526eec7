#include "solver/io/point_formats.h"

#include <catch2/catch.hpp>

namespace point_formats_test {
namespace {
using namespace plumbline;
using namespace std::string_literals;

struct BadInput {
    const char* name;
    std::string bytes;
    const char* message;
};

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 2\n"
    "property float x\nproperty float y\nend_header\n";
const std::string binary_ply =
    "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
    "property float x\nproperty float y\nend_header\n";

std::string vtp(const std::string& piece, const std::string& attributes = "type=\"PolyData\"") {
    return "<VTKFile " + attributes + "><PolyData>" + piece + "</PolyData></VTKFile>\n";
}
std::string vtp_points(const std::string& array) {
    return vtp("<Piece NumberOfPoints=\"1\"><Points>" + array + "</Points></Piece>");
}
std::string nested(std::size_t levels) {
    std::string xml;
    for (std::size_t k = 0; k < levels; ++k) xml += "<a>";
    return xml;
}

const BadInput bad_inputs[] = {
    // what is not a table at all
    {"a.csv", "", "a.csv:1:1: expected a header with the names of the columns, found none"},
    {"a.csv", "\n\n# a comment\n",
     "a.csv:1:1: expected a header with the names of the columns, found none"},
    {"a.csv", "\x89PNG\r\n\x1A\n junk", "a.csv:1:1: expected text, found a PNG image"},
    {"a.ply", "\x89PNG\r\n\x1A\n junk", "a.ply:1:1: expected text, found a PNG image"},
    {"a.vtp", "\x1F\x8B\x08 junk", "a.vtp:1:1: expected text, found a gzip archive"},
    {"a.dat", "PK\x03\x04 junk", "a.dat:1:1: expected text, found a ZIP archive"},
    {"a.csv", "x,y\n1,2\n3,\0004\n"s,
     "a.csv:3:3: expected text, found the control character \"\\x00\""},
    {"a.csv", "\xFF\xFEx\0,\0y\0"s, "a.csv:1:1: expected text, found text in UTF-16"},
    // CSV
    {"a.csv", "0.1,0.2\n0.3,0.4\n",
     "a.csv:1:1: expected a header that names the columns before the first point: x,y or x,y,z, "
     "and a "
     "name for each further one, as in x,y,f, found the numbers \"0.1,0.2\""},
    {"a.csv", "x;y\n1;2\n",
     "a.csv:1:1: expected a header x,y[,z][,further columns] with a column \"x\", found \"x;y\""},
    {"a.csv", "x,f\n1,2\n",
     "a.csv:1:1: expected a header x,y[,z][,further columns] with a column \"y\", found \"x,f\""},
    {"a.csv", "a,y\n1,2\n",
     "a.csv:1:1: expected a header x,y[,z][,further columns] with a column \"x\", found \"a,y\""},
    {"a.csv", "x,y,x\n1,2,3\n", "a.csv:1:5: expected each column once, found \"x\" twice"},
    {"a.csv", "x,y,\n1,2,\n", "a.csv:1:5: expected a name for each column, found an empty one"},
    {"a.csv", "x,y\n", "a.csv:1:1: expected at least one point below the header, found none"},
    {"a.csv", "x,y\n1,2\n3,abc\n", "a.csv:3:3: expected a finite number, found \"abc\""},
    {"a.csv", "x,y\n1,2\n3,\n", "a.csv:3:3: expected a finite number, found \"\""},
    {"a.csv", "x,y\n1,nan\n", "a.csv:2:3: expected a finite number, found \"nan\""},
    {"a.csv", "x,y\n-inf,1\n", "a.csv:2:1: expected a finite number, found \"-inf\""},
    {"a.csv", "x,y\n1,1e999\n",
     "a.csv:2:3: expected a number that fits into a double, found \"1e999\""},
    {"a.csv", "x,y\n1,0x10\n", "a.csv:2:3: expected a finite number, found \"0x10\""},
    {"a.csv", "x,y\n1,2,3\n",
     "a.csv:2:5: expected 2 fields as in the header, found 3 in \"1,2,3\""},
    {"a.csv", "x,y,f\n1,2,3\n4,5\n",
     "a.csv:3:4: expected 3 fields as in the header, found 2 in \"4,5\""},
    {"a.csv", "x,y\r\n1,2\r\n3,4 5\r\n", "a.csv:3:3: expected a finite number, found \"4 5\""},
    {"a.csv", "\xEF\xBB\xBFx,y\n1,z\n", "a.csv:2:3: expected a finite number, found \"z\""},
    {"a.csv", "x,\"y\n1,2\n", "a.csv:1:3: expected a closing quote, found \"\"y\""},
    {"größe.csv", "x,y,größe\n1,2,ä\n", "größe.csv:2:5: expected a finite number, found \"ä\""},
    // XYZ
    {"a.xyz", "1 2\n3 4\n", "a.xyz:1:1: expected x, y and z, found 2 values"},
    {"a.xyz", "1 2 3\n4 5\n", "a.xyz:2:3: expected 3 values as in the first row, found 2"},
    {"a.xyz", "1 2 3\n4 5 6 7\n", "a.xyz:2:7: expected 3 values as in the first row, found 4"},
    {"a.xyz", "1 2 3\n4 five 6\n", "a.xyz:2:3: expected a finite number, found \"five\""},
    {"a.xyz", "3\nwater\nO 0 0 0\nH 1 0 0\n",
     "a.xyz:1:1: expected the count of the points that follow, 2, found \"3\""},
    {"a.xyz", "-2\nwater\nO 0 0 0\nH 1 0 0\n",
     "a.xyz:1:1: expected a count (an integer that is not negative), found \"-2\""},
    {"a.xyz", "# nothing\n", "a.xyz:1:1: expected lines \"x y z\", found none"},
    // PLY
    {"a.ply", "x,y\n1,2\n", "a.ply:1:1: expected \"ply\", found \"x,y\""},
    {"a.ply", "ply\n",
     "a.ply:2:1: expected \"format ascii|binary_little_endian|binary_big_endian 1.0\", found \"\""},
    {"a.ply", "ply\nformat ascii 2.0\n",
     "a.ply:2:1: expected \"format ascii|binary_little_endian|binary_big_endian 1.0\", found "
     "\"format ascii 2.0\""},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 2\n",
     "a.ply:4:1: expected \"end_header\", found the end of the file"},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex two\n",
     "a.ply:3:16: expected a count (an integer that is not negative), found \"two\""},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n1\n",
     "a.ply:4:10: expected a PLY type such as float or double, found \"real\""},
    {"a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
     "a.ply:3:1: expected \"element NAME COUNT\", \"property TYPE NAME\" or \"end_header\", found "
     "\"property float x\""},
    {"a.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n",
     "a.ply:1:1: expected an element \"vertex\" in the header, found none"},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
     "a.ply:3:9: expected a scalar property \"y\" of the element vertex, found none of that name"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
     "end_header\n",
     "a.ply:3:9: expected at least one vertex, found none"},
    {"a.ply", ply + "1 2\n",
     "a.ply: vertex 2 of 2: expected its values, found the end of the file"},
    {"a.ply", ply + "1 2\n3\n",
     "a.ply:8:2: expected one more value of vertex 2 of 2, found the end of the line"},
    {"a.ply", ply + "1 2\n3 4 5\n",
     "a.ply:8:5: expected the end of the line, after vertex 2 of 2, found \"5\""},
    {"a.ply", ply + "1 2\n3 x\n", "a.ply:8:3: expected a finite number, found \"x\""},
    {"a.ply", binary_ply + std::string(15, '\0'),
     "a.ply: vertex 2 of 2: expected its values, found the end of the file"},
    {"a.ply", binary_ply + std::string(12, '\0') + "\x00\x00\xC0\x7F"s,
     "a.ply: vertex 2 of 2, property \"y\": expected a finite number, found nan"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 4000000000000\nproperty float x\n"
     "property float y\nend_header\n1 2\n",
     "a.ply:3:9: expected at most 4294967294 vertices, found 4000000000000"},
    {"a.ply",
     "ply\nformat binary_big_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
     "property float y\nend_header\n12345678",
     "a.ply: vertex 2 of 4000000000: expected its values, found the end of the file"},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nproperty float x\n",
     "a.ply:3:16: expected a count (an integer that is not negative), found "
     "\"99999999999999999999\""},
    // VTP
    {"a.vtp", "x,y\n1,2\n",
     "a.vtp:1: expected well-formed XML, found text that is not (expected <)"},
    {"a.vtp", "<VTKFile type=\"PolyData\">\n<PolyData>\n",
     "a.vtp:3: expected well-formed XML, found text that is not (unexpected end of data)"},
    {"a.vtp", "<svg></svg>", "a.vtp:1:1: expected the element <VTKFile>, found another one"},
    {"a.vtp", vtp("", "type=\"UnstructuredGrid\""),
     "a.vtp:1:1: expected <VTKFile type=\"PolyData\">, found type \"UnstructuredGrid\""},
    {"a.vtp", vtp("", "type=\"PolyData\" compressor=\"vtkZLibDataCompressor\""),
     "a.vtp:1:1: expected data that are not compressed (in ParaView: compressor None), found "
     "vtkZLibDataCompressor"},
    {"a.vtp", vtp(""), "a.vtp: PolyData: expected exactly one <Piece>, found 0"},
    {"a.vtp", vtp("<Piece><Points></Points></Piece>"),
     "a.vtp: Piece: expected NumberOfPoints from 1 to 4294967294, found \"\""},
    {"a.vtp", vtp("<Piece NumberOfPoints=\"0\"/>"),
     "a.vtp: Piece: expected NumberOfPoints from 1 to 4294967294, found \"0\""},
    {"a.vtp", vtp("<Piece NumberOfPoints=\"1\"/>"),
     "a.vtp: Piece: expected <Points> with a <DataArray>, found none"},
    {"a.vtp", vtp_points("<DataArray>1 2</DataArray>"),
     "a.vtp: DataArray \"Points\": expected 1 × 3 values, found 2"},
    {"a.vtp", vtp_points("<DataArray>1 2\nnan</DataArray>"),
     "a.vtp:2:1: expected a finite number, found \"nan\""},
    {"a.vtp", vtp_points("<DataArray>1 2\n\n  three</DataArray>"),
     "a.vtp:3:3: expected a finite number, found \"three\""},
    {"a.vtp", vtp_points("<DataArray type=\"Float64\" format=\"binary\">*</DataArray>"),
     "a.vtp: DataArray \"Points\": expected base64, found \"*\""},
    {"a.vtp", vtp_points("<DataArray type=\"Float64\" format=\"binary\">GAAAAA==</DataArray>"),
     "a.vtp: DataArray \"Points\": expected 24 bytes, found 0"},
    {"a.vtp", vtp_points("<DataArray type=\"Float80\" format=\"binary\">AAAAAA==</DataArray>"),
     "a.vtp: DataArray \"Points\": expected a type such as Float64, found \"Float80\""},
    {"a.vtp", vtp_points("<DataArray type=\"Float64\" format=\"appended\" offset=\"5\"/>"),
     "a.vtp: DataArray \"Points\": expected <AppendedData>, found none"},
    {"a.vtp", vtp_points("<DataArray format=\"gzip\"/>"),
     "a.vtp: DataArray \"Points\": expected format ascii, binary or appended, found \"gzip\""},
    {"a.vtp",
     vtp("<Piece NumberOfPoints=\"3000000000\"><Points><DataArray>1 2 3</DataArray>"
         "</Points></Piece>"),
     "a.vtp: DataArray \"Points\": expected 3000000000 × 3 values, found 3"},
    {"a.vtp", nested(100000), "a.vtp:1:301: expected at most 100 nested elements, found more"},
};

std::string message_for(const BadInput& input) {
    try {
        parse_points(input.name, input.bytes);
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return "accepted";
}
}  // namespace

TEST_CASE("each bad file of points has its message", "[io]") {
    for (const BadInput& input : bad_inputs) {
        INFO(input.bytes.substr(0, 200));
        CHECK(message_for(input) == input.message);
    }
}

}  // namespace point_formats_test
