#include "solver/scene/sph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_sph_3d(const SceneFile& file) { return make_sph<3>(file); }

}  // namespace plumbline
