#include "solver/io/scene_meshes.h"

#include "solver/foundation/errors.h"
#include "solver/particles/closed_mesh.h"
#include "solver/scene/simulation.h"
#include "verification/reports/program.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace scene_meshes_test {
namespace {
using namespace plumbline;
using namespace verification;

const std::string tetrahedron =
    "v 0.7 0.1 0.1\nv 0.9 0.1 0.1\nv 0.7 0.25 0.1\nv 0.7 0.1 0.3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 "
    "4\n";

SceneFile scene_in(const ScratchFolder& folder) {
    return SceneFile::parse((folder.path() / "s.toml").string(),
                            dam_break_scene(3, "delta_sph", 1.0) +
                                "[[constraint]]\nshape = \"mesh\"\nfile = \"m.obj\"\n");
}

TEST_CASE("meshes are read from beside the scene file") {
    const ScratchFolder folder;
    folder.write("m.obj", tetrahedron);
    SceneFile scene = scene_in(folder);
    CHECK_THROWS_AS(make_simulation(scene), InvalidInput);
    read_meshes(scene);
    REQUIRE(scene.constraints[0].shape.mesh);
    CHECK(scene.constraints[0].shape.mesh->volume() == Approx(0.2 * 0.15 * 0.2 / 6.0));
    CHECK_NOTHROW(make_simulation(scene));
}

TEST_CASE("a mesh that is missing or open is refused, with the place that asks for it") {
    const ScratchFolder folder;
    SceneFile scene = scene_in(folder);
    const std::string place = folder.path() / "s.toml:28:1: ";
    CHECK_THROWS_WITH(read_meshes(scene), Catch::StartsWith(place));
    folder.write("m.obj", tetrahedron.substr(0, tetrahedron.rfind("f 2")));
    CHECK_THROWS_WITH(read_meshes(scene), Catch::Contains("expected a closed surface"));
}
}  // namespace
}  // namespace scene_meshes_test
