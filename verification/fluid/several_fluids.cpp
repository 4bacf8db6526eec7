#include "solver/fluid/number_density.h"
#include "solver/fluid/tait_pressures.h"
#include "solver/fluid/volume_pressure_force.h"

#include "solver/fluid/pressure_force.h"
#include "solver/particles/lattice.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace several_fluids_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double h = 2.6, heavy = 1000.0;

/// A lattice of two fluids, the densities 1000 and 1, below and above the plane through the origin.
template <int Dim> Drop<Dim> two_layers() {
    Drop<Dim> layers;
    const auto around = Vec<Dim>::Constant(Dim == 2 ? 6.0 : 4.0);
    const auto points = lattice<Dim>({-around, around}, 1.0);
    layers.x.assign(points.begin(), points.end());
    layers.v.assign(points.size(), Vec<Dim>::Zero());
    layers.m.clear();
    for (const Vec<Dim>& x : points) layers.m.push_back(x[Dim - 1] < 0.0 ? heavy : 1.0);
    return layers;
}
/// max |ρ/m over its mean − 1|, that is of ρ/ρ₀, over particles farther than h from the edges.
template <int Dim, class Pass> double error_of_density(Pass density) {
    const Drop<Dim> layers = two_layers<Dim>();
    const auto scene = evaluated<Dim>(layers, density);
    const double inside = (Dim == 2 ? 6.0 : 4.0) - h;
    double least = HUGE_VAL, most = 0.0;
    for (std::size_t i = 0; i < layers.x.size(); ++i) {
        if (layers.x[i].cwiseAbs().maxCoeff() > inside) continue;
        const double ratio = scene.template get<Density>()[i] / layers.m[i];
        least = std::min(least, ratio), most = std::max(most, ratio);
    }
    return most / least - 1.0;
}
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

const Register jump{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "several_fluids.density_jumps",
                 .source = {Paper::literature, "Solenthaler and Pajarola 2008"},
                 .says =
                     "densities on both sides of the surface between fluids of 1000 and 1, over "
                     "those far from it: largest relative difference; by Eq. 5 the light one is "
                     "taken for hundreds of times too dense",
                 .bound = at_most(1e-14, "the same 20 to 80 terms in another order"),
                 .measure = [] { return error_of_density<D>(NumberDensity<W<D>>{W<D>(h)}); },
                 .sabotaged = [] { return error_of_density<D>(SphDensity<W<D>>{W<D>(h)}); }};
})};
const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "several_fluids", {Paper::literature, "Tartakovsky and Meakin 2005"},
        [] { return net_force<D>(pushed<D>(by_volumes<D>())); },
        [] { return net_force<D>(without_masses<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "several_fluids", {Paper::literature, "Tartakovsky and Meakin 2005"},
        [] { return net_torque<D>(pushed<D>(by_volumes<D>())); },
        [] { return net_torque<D>(without_masses<D>()); });
})};
const Register single{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "several_fluids.is_eq_51_for_one_fluid",
                 .source = {Paper::adams2009, "Eqs. 5, 51"},
                 .says =
                     "accelerations of a drop of equal masses against those by Eqs. 5 and 51; with "
                     "unequal masses the two differ",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return difference_from_eq_51<D>(true); },
                 .sabotaged = [] { return difference_from_eq_51<D>(false); }};
})};
}  // namespace
}  // namespace several_fluids_claims
