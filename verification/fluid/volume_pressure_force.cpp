#include "solver/fluid/volume_pressure_force.h"

#include "solver/fluid/number_density.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace volume_pressure_force_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double h = 2.6;

/// The drop, whose masses differ by a factor of 3, as of fluids of a common equation.
template <int Dim, class Force> auto pushed(Force force) {
    return evaluated<Dim>(Drop<Dim>{}, NumberDensity<W<Dim>>{W<Dim>(h)},
                          TaitPressure{TaitEquation(1.0, 10.0, 7.0)}, force);
}
template <int Dim> VolumePressureForce<W<Dim>> by_volumes() { return {W<Dim>(h)}; }
/// With masses forgotten after the accelerations are known.
template <int Dim> auto without_masses() {
    auto scene = pushed<Dim>(by_volumes<Dim>());
    std::ranges::fill(scene.template get<Masses>(), 1.0);
    return scene;
}
/// Of a drop of equal masses against Eq. 51, or of the one with unequal masses.
template <int Dim> double difference_from_eq_51(bool equal_masses) {
    Drop<Dim> drop;
    if (equal_masses) drop.m.assign(drop.x.size(), 1.3);
    const TaitPressure tait{TaitEquation(1.0, 10.0, 7.0)};
    const auto one =
        evaluated<Dim>(drop, NumberDensity<W<Dim>>{W<Dim>(h)}, tait, by_volumes<Dim>());
    const auto other = evaluated<Dim>(drop, tait, PressureForce<W<Dim>>{W<Dim>(h)});
    return largest_difference<Dim>(one.template get<Accelerations<Dim>>(),
                                   other.template get<Accelerations<Dim>>());
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "volume_pressure_force", {Paper::literature, "Tartakovsky and Meakin 2005"},
        [] { return net_force<D>(pushed<D>(by_volumes<D>())); },
        [] { return net_force<D>(without_masses<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "volume_pressure_force", {Paper::literature, "Tartakovsky and Meakin 2005"},
        [] { return net_torque<D>(pushed<D>(by_volumes<D>())); },
        [] { return net_torque<D>(without_masses<D>()); });
})};
const Register single{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "volume_pressure_force.is_eq_51_for_one_fluid",
                 .source = {Paper::adams2009, "Eqs. 5, 51"},
                 .says =
                     "accelerations of a drop of equal masses against those by Eqs. 5 and 51; with "
                     "unequal masses the two differ",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return difference_from_eq_51<D>(true); },
                 .sabotaged = [] { return difference_from_eq_51<D>(false); }};
})};
}  // namespace
}  // namespace volume_pressure_force_claims
