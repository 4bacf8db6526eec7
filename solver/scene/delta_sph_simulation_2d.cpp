#include "solver/scene/delta_sph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_delta_sph_2d(const SceneFile& file) {
    return make_delta_sph<2>(file);
}

}  // namespace plumbline
