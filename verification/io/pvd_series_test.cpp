#include "solver/io/pvd_series.h"

#include "verification/io/xml_check_test.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace pvd_series_test {
namespace {
using namespace plumbline;
using namespace verification;

TEST_CASE("a series names its files in the order of time") {
    std::ostringstream out;
    write_pvd(out, {{0.0, "p/a.vtp"}, {0.1, "p/b & c.vtp"}});
    const ScratchFolder folder;
    folder.write("s.pvd", out.str());
    CHECK(is_well_formed(folder, "s.pvd"));
    const std::size_t a = out.str().find("timestep=\"0\" part=\"0\" file=\"p/a.vtp\"");
    const std::size_t b =
        out.str().find("timestep=\"0.10000000000000001\" part=\"0\" file=\"p/b &amp; c.vtp\"");
    CHECK(a < b);
    CHECK(b != std::string::npos);
}
}  // namespace
}  // namespace pvd_series_test
