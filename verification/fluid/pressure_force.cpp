#include "solver/fluid/pressure_force.h"

#include "solver/fluid/plain_pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/spiky.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace pressure_force_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double h = 2.6;
template <int Dim> TaitPressure tait() { return {TaitEquation(1.0, 10.0, 7.0)}; }
template <int Dim> PressureForce<W<Dim>> by_eq_51() { return {W<Dim>(h)}; }
template <int Dim> PlainPressureForce<W<Dim>> by_eq_50() { return {W<Dim>(h)}; }

/// Two particles of masses 1 and 3: ‖m₁ a₁ + m₂ a₂‖ or, as printed, ‖a₁ + a₂‖, over ‖m₁ a₁‖.
template <int Dim> double asymmetry_of_a_pair(bool printed) {
    Drop<Dim> pair;
    pair.x = {Vec<Dim>::Zero(), Vec<Dim>::Constant(0.4)};
    pair.v.assign(2, Vec<Dim>::Zero());
    pair.m = {1.0, 3.0};
    const auto scene = evaluated<Dim>(pair, tait<Dim>(), by_eq_51<Dim>());
    const auto& a = scene.template get<Accelerations<Dim>>();
    const Vec<Dim> sum = printed ? Vec<Dim>(a[0] + a[1]) : Vec<Dim>(1.0 * a[0] + 3.0 * a[1]);
    return sum.norm() / a[0].norm();
}

/// E = Σ m e(ρ), with ρ by Eq. 5.
template <int Dim> double stored_energy(const Drop<Dim>& drop) {
    const auto scene = evaluated<Dim>(drop);
    const auto& rho = scene.template get<Density>();
    double total = 0.0;
    for (std::size_t i = 0; i < rho.size(); ++i)
        total += drop.m[i] * tait<Dim>().equation.energy(rho[i]);
    return total;
}
/// |Σ mᵢ aᵢ·uᵢ + dE/ds| / Σ mᵢ ‖aᵢ‖ ‖uᵢ‖ for x + s u, u being the velocities; dE/ds by a difference of
/// fourth order.
template <int Dim, class Force> double work_that_is_not_stored(Force force) {
    const Drop<Dim> drop;
    const auto scene = evaluated<Dim>(drop, tait<Dim>(), force);
    const auto& a = scene.template get<Accelerations<Dim>>();
    const auto moved = [&](double s) {
        Drop<Dim> d = drop;
        for (std::size_t i = 0; i < d.x.size(); ++i) d.x[i] += s * d.v[i];
        return stored_energy(d);
    };
    const double s = 1e-3;
    const double slope =
        (8.0 * (moved(s) - moved(-s)) - (moved(2 * s) - moved(-2 * s))) / (12.0 * s);
    double work = 0.0, size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        work += drop.m[i] * a[i].dot(drop.v[i]);
        size += drop.m[i] * a[i].norm() * drop.v[i].norm();
    }
    return std::abs(work + slope) / size;
}

template <int Dim, class Force> Drift after_1000_steps(Force force) {
    return drift<Dim>(scene_of(Drop<Dim>{}, tait<Dim>(), force, SymplecticEuler<Dim>{}), 1000,
                      2e-3);
}
constexpr const char* thousand_steps =
    "v + Δt a is rounded to 1.1e-16 of ‖v‖, independently: √(1000 / 50) of that per particle, "
    "5e-16; "
    "a pair sum is off by 70 · 1.1e-16 of a, Δt ‖a‖ < ‖v‖ / 10, and √1000 of these add up: 2.5e-14";

const Register laws{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "pressure_force", {Paper::adams2009, "Eqs. 19, 51; Sec. 6.1"},
        [] { return net_force_of<D>(tait<D>(), by_eq_51<D>()); },
        [] { return net_force_of<D>(tait<D>(), by_eq_50<D>()); });
})};
const Register turning{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "pressure_force", {Paper::adams2009, "Eq. 51; Sec. 6.1"},
        [] { return net_torque_of<D>(tait<D>(), by_eq_51<D>()); },
        [] { return net_torque_of<D>(tait<D>(), by_eq_50<D>()); });
})};
const Register pairs{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "pressure_force.is_opposite_in_pairs",
                 .source = {Paper::adams2009, "Eq. 51; Sec. 6.1"},
                 .says = "m₁ a₁ + m₂ a₂ = 0 for masses 1 and 3; printed: a₁ + a₂ = 0",
                 .bound = at_most(1e-15, "three products and one sum on each side: 8 · 1.1e-16"),
                 .measure = [] { return asymmetry_of_a_pair<D>(false); },
                 .sabotaged = [] { return asymmetry_of_a_pair<D>(true); },
                 .erratum = 19};
})};
const Register stored{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "pressure_force.is_the_slope_of_the_stored_energy",
        .source = {Paper::plumbline, "docstring of PressureForce"},
        .says = "the work of Eq. 51 is what Σ m e(ρ) loses, if ρ is summed with the same kernel",
        .bound = at_most(1e-6,
                         "s⁴/30 |E⁗′| with s = 1e-3 and derivatives growing by at most 50 per "
                         "order: 1e-12 · 50⁴ / 30 = 2e-7; rounding 1e-16 E / s is less"),
        .measure = [] { return work_that_is_not_stored<D>(by_eq_51<D>()); },
        .sabotaged =
            [] { return work_that_is_not_stored<D>(PressureForce<Spiky<D>>{Spiky<D>(h)}); }};
})};
const Register linear_drift{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "pressure_force.keeps_linear_momentum_for_1000_steps",
                 .source = {Paper::adams2009, "Eqs. 51, 58, 59; Sec. 6.1"},
                 .says = "‖P(1000) − P(0)‖ / Σ m ‖v‖; by Eq. 50 it drifts",
                 .bound = at_most(1e-13, thousand_steps),
                 .measure = [] { return after_1000_steps<D>(by_eq_51<D>()).linear; },
                 .sabotaged = [] { return after_1000_steps<D>(by_eq_50<D>()).linear; }};
})};
const Register angular_drift{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "pressure_force.keeps_angular_momentum_for_1000_steps",
                 .source = {Paper::adams2009, "Eqs. 51, 58, 59; Sec. 6.1"},
                 .says =
                     "‖L(1000) − L(0)‖ / Σ m ‖x‖ ‖v‖, as symplectic Euler keeps x × v exactly "
                     "under central forces; by Eq. 50 it drifts",
                 .bound = at_most(1e-13, thousand_steps),
                 .measure = [] { return after_1000_steps<D>(by_eq_51<D>()).angular; },
                 .sabotaged = [] { return after_1000_steps<D>(by_eq_50<D>()).angular; }};
})};
const Register errata_of_pressure{
    Erratum{19, {Paper::adams2009, "Sec. 6.1"}, "aᵢⱼ + aⱼᵢ = 0", "mᵢ aᵢⱼ + mⱼ aⱼᵢ = 0"}};
}  // namespace
}  // namespace pressure_force_claims
