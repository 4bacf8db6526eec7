#include "solver/scene/sph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_sph_2d(const SceneFile& file) { return make_sph<2>(file); }

}  // namespace plumbline
