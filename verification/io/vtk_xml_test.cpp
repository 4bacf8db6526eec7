#include "solver/io/vtk_xml.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace vtk_xml_test {
namespace {
using namespace plumbline;

TEST_CASE("text that XML would read otherwise is escaped") {
    CHECK(xml_escaped("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;");
}

TEST_CASE("an array in ascii has a value per line") {
    std::ostringstream out;
    write_vtk_array(out, "id", std::vector<std::int64_t>{7, -1}, VtpEncoding::ascii);
    CHECK(
        out.str() ==
        "<DataArray type=\"Int64\" Name=\"id\" NumberOfComponents=\"1\" format=\"ascii\">\n7\n-1\n"
        "</DataArray>\n");
}
}  // namespace
}  // namespace vtk_xml_test
