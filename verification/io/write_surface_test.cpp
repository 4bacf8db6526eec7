#include "solver/io/write_surface.h"

#include "solver/io/read_mesh.h"
#include "verification/io/xml_check_test.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace write_surface_test {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> Isosurface<Dim> ball() {
    ScalarGrid<Dim> grid{Vec<Dim>::Constant(-1.0), 0.25, {}};
    grid.size.fill(9);
    for (std::size_t node = 0; node < grid.nodes(); ++node)
        grid.values.push_back(grid.position(node).norm() - 0.7);
    return isosurface(grid, 0.0);
}

TEST_CASE("OBJ and PLY are read back as the same closed surface") {
    const auto s = ball<3>();
    const ScratchFolder folder;
    std::ostringstream obj, ply, vtp;
    write_surface_obj(obj, s);
    write_surface_ply(ply, s);
    write_vtp(vtp, poly_data_of(s));
    folder.write("s.obj", obj.str());
    folder.write("s.ply", ply.str());
    folder.write("s.vtp", vtp.str());
    for (const char* file : {"s.obj", "s.ply"}) {
        const TriangleMesh mesh = read_mesh(folder.path() / file);
        CHECK(mesh.triangles.size() == s.facets.size());
        CHECK(ClosedMesh(mesh).volume() == Approx(volume(s)).epsilon(1e-13));
    }
    CHECK(is_well_formed(folder, "s.vtp"));
}

TEST_CASE("in the plane facets are edges") {
    const auto s = ball<2>();
    std::ostringstream obj, ply;
    write_surface_obj(obj, s);
    write_surface_ply(ply, s);
    CHECK(obj.str().find("\nl ") != std::string::npos);
    CHECK(ply.str().find("element edge " + std::to_string(s.facets.size())) != std::string::npos);
    const PolyData data = poly_data_of(s);
    CHECK(data.kind == PolyData::Cells::edges);
    CHECK(data.corners.size() == 2 * s.facets.size());
    CHECK(data.points() == s.vertices.size());
}
}  // namespace
}  // namespace write_surface_test
