#include "solver/fluid/brookshaw_viscosity.h"

#include "solver/fluid/monaghan_viscosity.h"
#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/fluid/shear_wave.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace brookshaw_viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr std::string_view literature = "Brookshaw 1985, Morris et al. 1997";
template <int Dim> BrookshawViscosity<WendlandC2<Dim>> brookshaw() {
    return {WendlandC2<Dim>(Drop<Dim>::support), 1.0};
}
/// One density in the denominator, as in adams2009 Eq. 52.
template <int Dim> auto with_one_density() {
    return PairForce<Dim>([w = WendlandC2<Dim>(Drop<Dim>::support)](
                              Index i, const Neighbour<Dim>& n, const PairState<Dim>& s) {
        const double laplacian = n.r > 0.0 ? -2.0 * w.derivative(n.r) / n.r : 0.0;
        return Vec<Dim>(s.m[n.j] / s.rho[n.j] * laplacian * (s.v[n.j] - s.v[i]));
    });
}
/// Without the subtraction of vᵢ.
template <int Dim> auto of_neighbours_alone() {
    return PairForce<Dim>([w = WendlandC2<Dim>(Drop<Dim>::support)](
                              Index i, const Neighbour<Dim>& n, const PairState<Dim>& s) {
        const double laplacian = n.r > 0.0 ? -2.0 * w.derivative(n.r) / n.r : 0.0;
        return Vec<Dim>(s.m[n.j] / (s.rho[i] * s.rho[n.j]) * laplacian * s.v[n.j]);
    });
}
template <int Dim> double error_of_viscosity(double factor) {
    using Box = typename ShearWave<Dim>::Box;
    const WendlandC2<Dim> w(ShearWave<Dim>::support);
    return std::abs(
        factor * ShearWave<Dim>::viscosity(BrookshawViscosity<WendlandC2<Dim>, Box>{w, 1.0}) - 1.0);
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "brookshaw_viscosity", {Paper::adams2009, "Eq. 52; Sec. 6.2"},
        [] { return net_force_of<D>(brookshaw<D>()); },
        [] { return net_force_of<D>(with_one_density<D>()); }, 18);
})};
const Register frames{in_dimensions<2, 3>([]<int D>() {
    return galilean(
        "brookshaw_viscosity", {Paper::literature, literature},
        [] { return change_in_moving_frame<D>(brookshaw<D>()); },
        [] { return change_in_moving_frame<D>(of_neighbours_alone<D>()); });
})};
const Register energy{in_dimensions<2, 3>([]<int D>() {
    return dissipative(
        "brookshaw_viscosity", {Paper::literature, literature},
        [] { return power_of<D>(brookshaw<D>()); },
        [] {
            return power_of<D>(
                BrookshawViscosity<WendlandC2<D>>{WendlandC2<D>(Drop<D>::support), -1.0});
        });
})};
const Register torque{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "brookshaw_viscosity.brakes_a_rigid_motion",
        .source = {Paper::plumbline, "docstring of BrookshawViscosity"},
        .says = "a free drop that spins loses its spin, since forces are along vⱼ − vᵢ",
        .bound = at_least(1e-3, "rounding would be 1e-14: it is not conserved"),
        .measure = [] { return net_torque<D>(evaluated<D>(spinning(Drop<D>{}), brookshaw<D>())); },
        .sabotaged =
            [] {
                return net_torque<D>(evaluated<D>(
                    spinning(Drop<D>{}),
                    MonaghanViscosity<WendlandC2<D>>{WendlandC2<D>(Drop<D>::support), 1.0}));
            }};
})};
const Register accuracy{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "brookshaw_viscosity.of_a_shear_wave",
                 .source = {Paper::literature, literature},
                 .says = "a shear wave decays with μ/ρ: relative error of the viscosity",
                 .bound = at_most(0.025, error_of_shear_wave),
                 .measure = [] { return error_of_viscosity<D>(1.0); },
                 .sabotaged = [] { return error_of_viscosity<D>(0.5); }};
})};
}  // namespace
}  // namespace brookshaw_viscosity_claims
