#include "solver/fluid/laplacian_viscosity.h"

#include "solver/fluid/monaghan_viscosity.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/viscosity.h"
#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/fluid/shear_wave.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace laplacian_viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> LaplacianViscosity<Viscosity<Dim>> corrected() {
    return {Viscosity<Dim>(Drop<Dim>::support), 1.0};
}
/// mⱼ/ρⱼ, as printed.
template <int Dim> auto printed() {
    return PairForce<Dim>([w = Viscosity<Dim>(Drop<Dim>::support)](Index i, const Neighbour<Dim>& n,
                                                                   const PairState<Dim>& s) {
        return Vec<Dim>(s.m[n.j] / s.rho[n.j] * laplacian(w, n.r) * (s.v[n.j] - s.v[i]));
    });
}
template <int Dim> auto of_neighbours_alone() {
    return PairForce<Dim>([w = Viscosity<Dim>(Drop<Dim>::support)](Index i, const Neighbour<Dim>& n,
                                                                   const PairState<Dim>& s) {
        return Vec<Dim>(s.m[n.j] / (s.rho[i] * s.rho[n.j]) * laplacian(w, n.r) * s.v[n.j]);
    });
}
/// ω″ for Δω, as printed.
template <int Dim, class Space = OpenSpace<Dim>> auto with_second_derivative(double h) {
    return PairForce<Dim, Space>(
        [w = Poly6<Dim>(h)](Index i, const Neighbour<Dim>& n, const PairState<Dim>& s) {
            return Vec<Dim>(s.m[n.j] / (s.rho[i] * s.rho[n.j]) * w.second_derivative(n.r) *
                            (s.v[n.j] - s.v[i]));
        });
}
/// Two particles, a third of the support apart, with different velocities.
template <int Dim, class Force> double power_of_a_close_pair(Force force) {
    Drop<Dim> pair;
    pair.x = {Vec<Dim>::Zero(), Drop<Dim>::support / 3.0 * Vec<Dim>::Unit(0)};
    pair.v = {Vec<Dim>::Zero(), Vec<Dim>::Ones()};
    pair.m.assign(2, 1.0);
    return power<Dim>(evaluated<Dim>(pair, force));
}

/// max ‖2 a′ − a‖ / max ‖a‖, a′ with twice the density and the same μ.
template <int Dim, class Force> double change_with_density(Force force) {
    Drop<Dim> drop;
    const auto light = evaluated<Dim>(drop, force);
    for (double& m : drop.m) m *= 2.0;
    auto doubled = evaluated<Dim>(drop, force).template get<Accelerations<Dim>>();
    for (auto& a : doubled) a *= 2.0;
    return largest_difference<Dim>(doubled, light.template get<Accelerations<Dim>>());
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "laplacian_viscosity", {Paper::adams2009, "Eqs. 46, 48, 52; Sec. 6.2"},
        [] { return net_force_of<D>(corrected<D>()); },
        [] { return net_force_of<D>(printed<D>()); }, 18);
})};
const Register density{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "laplacian_viscosity.has_the_unit_of_an_acceleration",
        .source = {Paper::adams2009, "Eqs. 44, 46, 48"},
        .says = "μ Δv / ρ: the same μ accelerates a fluid of twice the density half as much",
        .bound = at_most(0.0, "factors of two are exact"),
        .measure = [] { return change_with_density<D>(corrected<D>()); },
        .sabotaged = [] { return change_with_density<D>(printed<D>()); },
        .erratum = 39};
})};
const Register frames{in_dimensions<2, 3>([]<int D>() {
    return galilean(
        "laplacian_viscosity", {Paper::adams2009, "Eq. 52"},
        [] { return change_in_moving_frame<D>(corrected<D>()); },
        [] { return change_in_moving_frame<D>(of_neighbours_alone<D>()); });
})};
const Register torque{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "laplacian_viscosity.turns_a_free_drop",
        .source = {Paper::plumbline, "docstring of LaplacianViscosity"},
        .says = "‖Σ xᵢ × mᵢ aᵢ‖ of a drop that spins: angular momentum is lost",
        .bound = at_least(1e-3, "rounding would be 1e-14: it is not conserved"),
        .measure = [] { return net_torque<D>(evaluated<D>(spinning(Drop<D>{}), corrected<D>())); },
        .sabotaged =
            [] {
                return net_torque<D>(evaluated<D>(
                    spinning(Drop<D>{}),
                    MonaghanViscosity<WendlandC2<D>>{WendlandC2<D>(Drop<D>::support), 1.0}));
            }};
})};
const Register energy{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "laplacian_viscosity.brakes_close_pairs",
        .source = {Paper::adams2009, "Eqs. 11, 52; Sec. 6.2"},
        .says =
            "Σ mᵢ aᵢ·vᵢ < 0 for two particles a third of the support apart; by ω″ of "
            "poly6, negative for r < h/√5, they drive each other apart",
        .bound = at_most(0.0, "−m² Δω ‖v‖² / ρ², and Δω ≥ 0 for the viscosity kernel"),
        .measure = [] { return power_of_a_close_pair<D>(corrected<D>()); },
        .sabotaged =
            [] { return power_of_a_close_pair<D>(with_second_derivative<D>(Drop<D>::support)); },
        .erratum = 17};
})};
const Register accuracy{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "laplacian_viscosity.of_a_shear_wave",
        .source = {Paper::adams2009, "Eqs. 11, 52"},
        .says =
            "a shear wave decays with μ/ρ: effective viscosity in units of μ/ρ; with ω″ it is "
            "(dim + 1)/2 in the continuum, and more than 1.3 on this lattice",
        .bound = between(0.9, 1.1,
                         "trapezoid rule with 3 spacings per support over a cone, whose "
                         "slope jumps: (1/3)² of the integral at most"),
        .measure =
            [] {
                using Box = typename ShearWave<D>::Box;
                return ShearWave<D>::viscosity(LaplacianViscosity<Viscosity<D>, Box>{
                    Viscosity<D>(ShearWave<D>::support), 1.0});
            },
        .sabotaged =
            [] {
                using Box = typename ShearWave<D>::Box;
                return ShearWave<D>::viscosity(
                    with_second_derivative<D, Box>(ShearWave<D>::support));
            },
        .erratum = 17};
})};
const Register errata_of_viscosity{Erratum{18,
                                           {Paper::adams2009, "Eq. 52; Sec. 6.2"},
                                           "mⱼ/ρⱼ; \"the force is symmetric\"",
                                           "mⱼ/(ρᵢ ρⱼ), and even so no angular momentum is kept"},
                                   Erratum{39,
                                           {Paper::adams2009, "Eq. 48"},
                                           "μ (Δv)(xᵢ)",
                                           "μ/ρᵢ (Δv)(xᵢ), as Eqs. 44 and 46 have it"}};
}  // namespace
}  // namespace laplacian_viscosity_claims
