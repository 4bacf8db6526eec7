#include "solver/fluid/ghost_xsph.h"

#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace ghost_xsph_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    return Wall::template difference_at_wall<VelocityTowardsMean<Dim>>(
        with_ghosts, AverageVelocities<W>{Wall::kernel()},
        AverageGhostVelocities<W>{Wall::kernel()});
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_xsph.ghosts_stand_for_fluid",
                 .source = {Paper::adams2009, "Eqs. 53, 57; Sec. 6.3"},
                 .says =
                     "the average of XSPH at a wall that moves as the fluid beyond it would is "
                     "that inside; without ghosts the fluid slips",
                 .bound = at_most(rounding_of_walls, same_pairs),
                 .measure = [] { return difference<D>(true); },
                 .sabotaged = [] { return difference<D>(false); }};
})};
}  // namespace
}  // namespace ghost_xsph_claims
