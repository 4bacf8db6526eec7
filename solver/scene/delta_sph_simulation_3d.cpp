#include "solver/scene/delta_sph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_delta_sph_3d(const SceneFile& file) {
    return make_delta_sph<3>(file);
}

}  // namespace plumbline
