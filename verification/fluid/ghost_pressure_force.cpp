#include "solver/fluid/ghost_pressure_force.h"

#include "solver/fluid/pressure_force.h"
#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace ghost_pressure_force_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    return Wall::template difference_at_wall<Accelerations<Dim>>(
        with_ghosts, PressureForce<W>{Wall::kernel()}, GhostPressureForce<W>{Wall::kernel()});
}

struct SetPressure {
    using Reads = Quantities<>;
    using Writes = Quantities<Pressure>;
    double value;
    void run(double, Pressure& p) const { std::ranges::fill(p, value); }
};
/// max ‖a‖ by the ghosts under the pressure p.
template <int Dim> double pull(double p) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    const auto scene = Wall::evaluate(true, SetPressure{p}, GhostPressureForce<W>{Wall::kernel()});
    double largest = 0.0;
    for (const Vec<Dim>& a : scene.template get<Accelerations<Dim>>())
        largest = std::max(largest, a.norm());
    return largest;
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_pressure_force.ghosts_stand_for_fluid",
                 .source = {Paper::adams2009, "Eqs. 51, 55; Sec. 6.3"},
                 .says =
                     "forces at a wall under constant pressure are those inside the fluid; without "
                     "ghosts it is pushed out",
                 .bound = at_most(rounding_of_walls, same_pairs),
                 .measure = [] { return difference<D>(true); },
                 .sabotaged = [] { return difference<D>(false); }};
})};
const Register push{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_pressure_force.does_not_pull",
                 .source = {Paper::plumbline, "docstring of GhostPressureForce"},
                 .says = "max ‖a‖ by the ghosts where the pressure is negative",
                 .bound = at_most(0.0, "left out altogether"),
                 .measure = [] { return pull<D>(-1.0); },
                 .sabotaged = [] { return pull<D>(1.0); }};
})};
}  // namespace
}  // namespace ghost_pressure_force_claims
