#include "solver/fluid/ghost_viscosity.h"

#include "solver/fluid/brookshaw_viscosity.h"
#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace ghost_viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The difference of a lattice that is fluid throughout from one with a wall, with its ghosts or without.
template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    const W w = Wall::kernel();
    const auto everything = Wall::evaluate(false, BrookshawViscosity<W>{w, 1.0});
    if (!with_ghosts)
        return Wall::template difference<Accelerations<Dim>>(
            everything, Wall::evaluate(true, BrookshawViscosity<W>{w, 1.0}));
    return Wall::template difference<Accelerations<Dim>>(
        everything, Wall::evaluate(true, BrookshawViscosity<W>{w, 1.0}, GhostViscosity<W>{w, 1.0}));
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_viscosity.ghosts_stand_for_fluid",
                 .source = {Paper::adams2009, "Eqs. 52, 56; Sec. 6.3"},
                 .says =
                     "viscous forces at a wall that moves as the fluid beyond it would are those "
                     "inside; without ghosts the fluid slips",
                 .bound = at_most(rounding_of_walls, same_pairs),
                 .measure = [] { return difference<D>(true); },
                 .sabotaged = [] { return difference<D>(false); }};
})};
}  // namespace
}  // namespace ghost_viscosity_claims
