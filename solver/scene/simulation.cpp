#include "solver/scene/simulation.h"

#include "solver/scene/composed.h"

namespace plumbline {

std::unique_ptr<Simulation> make_simulation(const SceneFile& scene) {
    const bool plane = scene.dim == 2;
    if (scene.method == Method::dfsph) return plane ? make_dfsph_2d(scene) : make_dfsph_3d(scene);
    if (scene.method == Method::sph) return plane ? make_sph_2d(scene) : make_sph_3d(scene);
    return plane ? make_delta_sph_2d(scene) : make_delta_sph_3d(scene);
}

}  // namespace plumbline
