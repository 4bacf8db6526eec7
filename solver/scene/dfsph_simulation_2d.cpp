#include "solver/scene/dfsph_simulation.h"

namespace plumbline {

std::unique_ptr<Simulation> make_dfsph_2d(const SceneFile& file) { return make_dfsph<2>(file); }

}  // namespace plumbline
