#include "solver/io/scene_meshes.h"

#include "solver/foundation/errors.h"
#include "solver/io/read_mesh.h"

namespace plumbline {

void read_meshes(SceneFile& scene) {
    const std::filesystem::path folder = std::filesystem::path(scene.name).parent_path();
    const auto read = [&](SolidShape& solid, const std::string& place) {
        if (solid.form != SolidShape::Form::mesh) return;
        try {
            solid.mesh = std::make_shared<const ClosedMesh>(read_mesh(folder / solid.mesh_file));
        } catch (const InvalidInput& e) {
            throw InvalidInput(place + ": " + e.what());
        }
    };
    for (SolidConstraint& constraint : scene.constraints) read(constraint.shape, constraint.place);
    for (SolidShape& outflow : scene.outflows) read(outflow, scene.name);
    for (SceneBody& body : scene.bodies) read(body.shape, body.place);
}

}  // namespace plumbline
