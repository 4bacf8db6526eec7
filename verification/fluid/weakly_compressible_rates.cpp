#include "solver/fluid/weakly_compressible_rates.h"

#include "solver/fluid/artificial_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "solver/particles/lattice.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace weakly_compressible_rates_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double h = 2.6, sound = 10.0, alpha = 0.2, delta = 0.1;
template <int Dim> TaitPressure tait() { return {TaitEquation(1.0, sound, 7.0)}; }
/// `factor` is 2 where the support is mistaken for the smoothing length.
template <int Dim, class Real = double>
WeaklyCompressibleRates<W<Dim>, Real> fused(double factor = 1.0) {
    return {W<Dim>(h), sound, factor * alpha, factor * delta};
}
/// Of the accelerations and of the rates of density: max ‖q − q′‖ / max ‖q′‖, q′ by the four passes.
template <int Dim, class Real> double difference_from_passes(double factor) {
    const Drop<Dim> drop;
    const auto plain = evaluated<Dim>(drop, tait<Dim>(), Continuity<W<Dim>>{W<Dim>(h)},
                                      DensityDiffusion<W<Dim>>{W<Dim>(h), delta, sound},
                                      PressureForce<W<Dim>>{W<Dim>(h)},
                                      ArtificialViscosity<W<Dim>>{W<Dim>(h), alpha, sound});
    const auto fast = evaluated<Dim>(drop, tait<Dim>(), fused<Dim, Real>(factor));
    const auto& rate = fast.template get<Rate<Density>>();
    const auto& plain_rate = plain.template get<Rate<Density>>();
    double worst = 0.0, size = 0.0;
    for (std::size_t i = 0; i < rate.size(); ++i) {
        worst = std::max(worst, std::abs(rate[i] - plain_rate[i]));
        size = std::max(size, std::abs(plain_rate[i]));
    }
    return std::max(worst / size,
                    largest_difference<Dim>(fast.template get<Accelerations<Dim>>(),
                                            plain.template get<Accelerations<Dim>>()));
}

/// The drop, with masses that are forgotten after the accelerations are known: m is 0.5 to 1.5.
template <int Dim> auto without_masses() {
    auto scene = evaluated<Dim>(Drop<Dim>{}, tait<Dim>(), fused<Dim>());
    std::ranges::fill(scene.template get<Masses>(), 1.0);
    return scene;
}

/// max ‖a‖ of a lattice of 6 particles along each edge, at rest under constant pressure, in a box.
template <int Dim> double acceleration_of_lattice(double edge_of_box) {
    using Box = PeriodicBox<Dim>;
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, Masses, Density, Pressure>{},
                WeaklyCompressibleRates<W<Dim>, double, Box>{
                    W<Dim>(h), sound, alpha, delta,
                    Box(Vec<Dim>::Zero(), Vec<Dim>::Constant(edge_of_box))}};
    const auto points = lattice<Dim>({Vec<Dim>::Zero(), Vec<Dim>::Constant(6.0)}, 1.0);
    scene.template get<Positions<Dim>>().assign(points.begin(), points.end());
    scene.template get<Velocities<Dim>>().assign(points.size(), Vec<Dim>::Zero());
    scene.template get<Masses>().assign(points.size(), 1.0);
    scene.template get<Density>().assign(points.size(), 1.0);
    scene.template get<Pressure>().assign(points.size(), 1.0);
    scene.step(0.0);
    double worst = 0.0;
    for (const Vec<Dim>& a : scene.template get<Accelerations<Dim>>())
        worst = std::max(worst, a.norm());
    return worst;
}

const Register agreement{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "weakly_compressible_rates.are_those_of_the_four_passes",
        .source = {Paper::plumbline, "docstring of WeaklyCompressibleRates"},
        .says =
            "accelerations and rates of density against Continuity, DensityDiffusion, "
            "PressureForce and ArtificialViscosity: largest difference over the largest; "
            "wrong: the support taken for the smoothing length",
        .bound = at_most(2e-13,
                         "30 roundings in a pair and 70 terms, each way: 200 · 1.1e-16 of Σ "
                         "|terms|, which is below 10 times the largest sum"),
        .measure = [] { return difference_from_passes<D, double>(1.0); },
        .sabotaged = [] { return difference_from_passes<D, double>(2.0); }};
})};
const Register single{in_dimensions<3>([]<int D>() {
    return Claim{
        .id = "weakly_compressible_rates.in_single_precision",
        .source = {Paper::plumbline, "docstring of WeaklyCompressibleRates"},
        .says = "the same with sums in single precision",
        .bound = at_most(6e-5,
                         "30 roundings in a pair and 70 terms: 100 · 6e-8 of Σ |terms|, which is "
                         "below 10 times the largest sum"),
        .measure = [] { return difference_from_passes<D, float>(1.0); },
        .sabotaged = [] { return difference_from_passes<D, float>(2.0); }};
})};
const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "weakly_compressible_rates", {Paper::adams2009, "Eq. 51; Sec. 6.1"},
        [] { return net_force_of<D>(tait<D>(), fused<D>()); },
        [] { return net_force<D>(without_masses<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "weakly_compressible_rates", {Paper::adams2009, "Eq. 51; Sec. 6.1"},
        [] { return net_torque_of<D>(tait<D>(), fused<D>()); },
        [] { return net_torque<D>(without_masses<D>()); });
})};
const Register periodic{in_dimensions<2>([]<int D>() {
    return Claim{.id = "weakly_compressible_rates.knows_periodic_boxes",
                 .source = {Paper::plumbline, "docstring of WeaklyCompressibleRates"},
                 .says =
                     "a lattice that repeats without end is in balance: max ‖a‖; in open space "
                     "it is not",
                 .bound = at_most(1e-13,
                                  "20 to 80 terms p/ρ² ω′ < 2 that cancel: 80 · 2 · 1.1e-16, and "
                                  "differences of coordinates rounded to 4e-16"),
                 .measure = [] { return acceleration_of_lattice<D>(6.0); },
                 .sabotaged = [] { return acceleration_of_lattice<D>(6.5); }};
})};
}  // namespace
}  // namespace weakly_compressible_rates_claims
