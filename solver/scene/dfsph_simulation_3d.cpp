#include "solver/scene/dfsph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_dfsph_3d(const SceneFile& file) { return make_dfsph<3>(file); }

}  // namespace plumbline
