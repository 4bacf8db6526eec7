#include "solver/fluid/ghost_xsph.h"

#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace {
using namespace plumbline;
using namespace verification;

/// The difference of a lattice that is fluid throughout from one with a wall, with its ghosts or without.
template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    const W w = Wall::kernel();
    const auto everything = Wall::evaluate(false, AverageVelocities<W>{w});
    if (!with_ghosts)
        return Wall::template difference<VelocityTowardsMean<Dim>>(
            everything, Wall::evaluate(true, AverageVelocities<W>{w}));
    return Wall::template difference<VelocityTowardsMean<Dim>>(
        everything, Wall::evaluate(true, AverageVelocities<W>{w}, AverageGhostVelocities<W>{w}));
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
