#include "solver/io/read_mesh.h"

#include <catch2/catch.hpp>

#include <fstream>

namespace read_mesh_test {
namespace {
using namespace plumbline;

class File {
public:
    File(const std::string& name, const std::string& content)
        : path_{std::filesystem::temp_directory_path() / ("plumbline_read_mesh_" + name)} {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~File() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

// The corner of a cube: vertices 0, e_x, e_y, e_z, volume 1/6.
const std::string off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nelement face 4\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string facet(const char* a, const char* b, const char* c) {
    return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b +
           "\nvertex " + c + "\nendloop\nendfacet\n";
}
const std::string stl = "solid corner\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                        facet("0 0 0", "1 0 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0") +
                        facet("1 0 0", "0 1 0", "0 0 1") + "endsolid corner\n";
// Two squares and an L of six corners, not convex, as a prism of height 1: volume 3.
const std::string l_prism =
    "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n"
    "0 2 1\n6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n"
    "4 4 5 11 10\n4 5 0 6 11\n";

std::string error_of(const std::string& name, const std::string& content) {
    const File file(name, content);
    try {
        ClosedMesh(read_mesh(file.path()));
    } catch (const InvalidInput& e) {
        const std::string message = e.what(), path = file.path().string();
        return message.starts_with(path) ? message.substr(path.size()) : message;
    }
    return "accepted";
}
}  // namespace

TEST_CASE("meshes: the same body from OFF, OBJ, PLY and STL", "[io]") {
    const std::pair<const char*, std::string> files[] = {
        {"a.off", off}, {"a.obj", obj}, {"a.ply", ply}, {"a.stl", stl}};
    for (const auto& [name, content] : files) {
        INFO(name);
        const File file(name, content);
        const TriangleMesh mesh = read_mesh(file.path());
        CHECK(mesh.vertices.size() == 4);
        CHECK(mesh.triangles.size() == 4);
        CHECK(std::abs(ClosedMesh(mesh).volume() - 1.0 / 6.0) < 1e-16);
    }
}

TEST_CASE("meshes: a polygon that is not convex is cut inside", "[io]") {
    const File file("l.off", l_prism);
    const ClosedMesh body(read_mesh(file.path()));
    CHECK(std::abs(body.volume() - 3.0) < 1e-15);
    CHECK(body.contains({0.5, 1.5, 0.5}));
    CHECK_FALSE(body.contains({1.5, 1.5, 0.5}));
}

TEST_CASE("meshes: bad ones have their message", "[io]") {
    const std::string expected =
        ": expected a mesh in the format of its extension (.obj, .off, .ply "
        "or .stl), found ";
    CHECK(error_of("b.off", "x,y\n1,2\n") == expected + "something else");
    CHECK(error_of("b.dat", off) == expected + "something else");
    CHECK(error_of("b.off", off.substr(0, 40)) == expected + "something else");
    CHECK(error_of("b.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n") == expected + "no faces");
    CHECK(error_of("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n") ==
          expected + "something else");
    CHECK(error_of("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 8\n").starts_with(expected));
    CHECK(error_of("b.off", "OFF\n4000000000 4000000000 0\n0 0 0\n") ==
          expected + "something else");
    CHECK(error_of("b.off", "") == ": expected a readable file, found an empty one");
    CHECK(error_of("open.off",
                   "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n") ==
          "mesh: expected a closed surface, found 3 edges with a triangle on one side only");
    CHECK_THROWS_WITH(read_mesh("none.off"),
                      "none.off: expected a readable file, found none of that name");
}

TEST_CASE("meshes: bodies that cannot be", "[io]") {
    const auto message = [](const TriangleMesh& mesh) -> std::string {
        try {
            ClosedMesh body(mesh);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return "accepted";
    };
    const File file("c.off", off);
    const TriangleMesh good = read_mesh(file.path());
    CHECK(message({good.vertices, {}}) == "mesh: expected at least one triangle, found none");
    CHECK(message({good.vertices, {{0, 1, 4}}}) ==
          "mesh: triangle 0: expected corners below 4, found 4");
    TriangleMesh bad = good;
    bad.vertices[2][1] = HUGE_VAL;
    CHECK(message(bad) == "mesh: vertex 2: expected finite coordinates, found others");
    bad = good;
    bad.triangles.push_back({0, 1, 2});
    CHECK(message(bad) ==
          "mesh: expected a surface, found edges shared by more than two triangles "
          "or triangles that cannot be oriented alike");
    // A second tetrahedron through the first.
    TriangleMesh crossed = good;
    for (const Vec<3>& x : good.vertices) crossed.vertices.push_back(x + Vec<3>::Constant(0.1));
    for (const auto& t : good.triangles)
        crossed.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    CHECK(message(crossed) ==
          "mesh: expected a surface that does not cut itself, found one that does");
}

}  // namespace read_mesh_test
