#include "solver/fluid/ghost_continuity.h"

#include "solver/fluid/continuity.h"
#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace ghost_continuity_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    return Wall::template difference_at_wall<Rate<Density>>(
        with_ghosts, Continuity<W>{Wall::kernel()}, GhostContinuity<W>{Wall::kernel()});
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_continuity.ghosts_stand_for_fluid",
                 .source = {Paper::adams2009, "Eq. 55; Sec. 6.3"},
                 .says =
                     "rates of the density at a wall whose ghosts continue the lattice, and its "
                     "velocities, are those inside",
                 .bound = at_most(rounding_of_walls, same_pairs),
                 .measure = [] { return difference<D>(true); },
                 .sabotaged = [] { return difference<D>(false); }};
})};
}  // namespace
}  // namespace ghost_continuity_claims
