#include "solver/fluid/monaghan_viscosity.h"

#include "solver/fluid/brookshaw_viscosity.h"
#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/fluid/shear_wave.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"

namespace monaghan_viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr std::string_view literature = "Monaghan 2005";
template <int Dim> using W = WendlandC2<Dim>;
template <int Dim> MonaghanViscosity<W<Dim>> monaghan(double mu = 1.0) {
    return {W<Dim>(Drop<Dim>::support), mu};
}
template <int Dim> BrookshawViscosity<W<Dim>> brookshaw() {
    return {W<Dim>(Drop<Dim>::support), 1.0};
}
/// ρⱼ alone in the denominator.
template <int Dim> auto with_one_density() {
    return PairForce<Dim>([w = W<Dim>(Drop<Dim>::support)](Index i, const Neighbour<Dim>& n,
                                                           const PairState<Dim>& s) {
        if (n.r == 0.0) return Vec<Dim>(Vec<Dim>::Zero());
        const double approach = (s.v[i] - s.v[n.j]).dot(n.x) / (n.r * n.r);
        return Vec<Dim>(s.m[n.j] / s.rho[n.j] * approach * gradient(w, n));
    });
}
/// |viscosity of the shear wave / its sum over the lattice − 1|; the sum has `factor` and
/// (vᵢⱼ·xᵢⱼ) xᵢⱼ along x.
template <int Dim> double difference_from_lattice_sum(double factor) {
    using Box = typename ShearWave<Dim>::Box;
    const W<Dim> w(ShearWave<Dim>::support);
    const double found = ShearWave<Dim>::viscosity(MonaghanViscosity<W<Dim>, Box>{w, 1.0});
    const double expected = ShearWave<Dim>::lattice_sum(
        [&](double x, double r) { return -factor * w.derivative(r) / r * x * x / (r * r); });
    return std::abs(found / expected - 1.0);
}
/// The viscosity where the sum is an integral, (dim + 2) ∫ −ω′/r x² y² / (r² + least h²) dV, in which x² y²
/// is r⁴ / (dim (dim + 2)) on average.
template <int Dim> double in_the_continuum(double least) {
    const W<Dim> w(0.8);
    const double surface = Dim == 2 ? 2.0 * std::numbers::pi : 4.0 * std::numbers::pi;
    const auto shell = [&](double r) {
        return -w.derivative(r) * r * r * r / (r * r + least * 0.64) * surface *
               std::pow(r, Dim - 1);
    };
    return integrate(shell, 0.0, w.support()) / Dim;
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "monaghan_viscosity", {Paper::literature, literature},
        [] { return net_force_of<D>(monaghan<D>()); },
        [] { return net_force_of<D>(with_one_density<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "monaghan_viscosity", {Paper::literature, literature},
        [] { return net_torque_of<D>(monaghan<D>()); },
        [] { return net_torque_of<D>(brookshaw<D>()); });
})};
const Register drifts{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "monaghan_viscosity.keeps_angular_momentum_for_1000_steps",
        .source = {Paper::literature, literature},
        .says = "‖L(1000) − L(0)‖ / Σ m ‖x‖ ‖v‖; by Brookshaw's form the drop stops to spin",
        .bound = at_most(1e-13,
                         "v + Δt a is rounded to 1.1e-16 of ‖v‖, independently: √(1000 / 50) of "
                         "that per particle; pair sums add less, as Δt ‖a‖ < ‖v‖ / 100"),
        .measure =
            [] {
                return drift<D>(
                           scene_of(spinning(Drop<D>{}), monaghan<D>(0.1), SymplecticEuler<D>{}),
                           1000, 2e-3)
                    .angular;
            },
        .sabotaged =
            [] {
                return drift<D>(scene_of(spinning(Drop<D>{}), brookshaw<D>(), SymplecticEuler<D>{}),
                                1000, 2e-3)
                    .angular;
            }};
})};
const Register rigid{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "monaghan_viscosity.does_not_brake_a_rigid_motion",
                 .source = {Paper::literature, literature},
                 .says = "max ‖a‖ of a drop in rigid motion, over that of random velocities",
                 .bound = at_most(1e-13,
                                  "v·x = (ω × x)·x = 0 but for roundings of v up to 8 to 8.9e-16, "
                                  "ten such terms for velocities of size 1, summed 70 times"),
                 .measure = [] { return braking_of_rigid_motion<D>(monaghan<D>()); },
                 .sabotaged = [] { return braking_of_rigid_motion<D>(brookshaw<D>()); }};
})};
const Register frames{in_dimensions<2, 3>([]<int D>() {
    return galilean(
        "monaghan_viscosity", {Paper::literature, literature},
        [] { return change_in_moving_frame<D>(monaghan<D>()); },
        [] {
            return change_in_moving_frame<D>(PairForce<D>(
                [w = W<D>(Drop<D>::support)](Index, const Neighbour<D>& n, const PairState<D>& s) {
                    return Vec<D>(s.m[n.j] * s.v[n.j].dot(n.x) * gradient(w, n));
                }));
        });
})};
const Register energy{in_dimensions<2, 3>([]<int D>() {
    return dissipative(
        "monaghan_viscosity", {Paper::literature, literature},
        [] { return power_of<D>(monaghan<D>()); }, [] { return power_of<D>(monaghan<D>(-1.0)); });
})};
const Register accuracy{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "monaghan_viscosity.of_a_shear_wave",
                 .source = {Paper::literature, literature},
                 .says =
                     "on a periodic lattice a shear wave decays by the sum over the lattice, whose "
                     "factor is 2 (dim + 2): 8 in the plane, 10 in space",
                 .bound = at_most(1e-11,
                                  "1 − cos(k y) ≥ 0.012 and its sums, to 1e-15 of 1, over k² "
                                  "and 40 terms: 40 · 2.2e-16 / 0.012, and ρ² likewise"),
                 .measure = [] { return difference_from_lattice_sum<D>(2.0 * (D + 2)); },
                 .sabotaged = [] { return difference_from_lattice_sum<D>(D == 2 ? 10.0 : 8.0); }};
})};
const Register continuum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "monaghan_viscosity.needs_no_small_number",
        .source = {Paper::plumbline, "docstring of MonaghanViscosity"},
        .says =
            "with many neighbours the viscosity is μ; with r² + 0.01 h², h being the "
            "support, several per cent of it are lost",
        .bound = between(1.0 - 1e-12, 1.0 + 1e-12, "relative accuracy of the quadrature 1e-13"),
        .measure = [] { return in_the_continuum<D>(0.0); },
        .sabotaged = [] { return in_the_continuum<D>(0.01); }};
})};
}  // namespace
}  // namespace monaghan_viscosity_claims
