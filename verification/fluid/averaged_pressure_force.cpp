#include "solver/fluid/averaged_pressure_force.h"

#include "solver/fluid/plain_pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace averaged_pressure_force_claims {
namespace {
using namespace plumbline;
using namespace verification;

const TaitEquation equation(1.0, 10.0, 7.0);
template <int Dim> AveragedPressureForce<WendlandC2<Dim>> averaged() {
    return {WendlandC2<Dim>(Drop<Dim>::support)};
}
/// ρⱼ² in the denominator, which is symmetric for equal densities only.
template <int Dim> auto with_one_density() {
    return PairForce<Dim>([w = WendlandC2<Dim>(Drop<Dim>::support)](
                              Index i, const Neighbour<Dim>& n, const PairState<Dim>& s) {
        const double rho = s.rho[n.j], p = equation.pressure(s.rho[i]) + equation.pressure(rho);
        return Vec<Dim>(-s.m[n.j] * p / (rho * rho) * gradient(w, n));
    });
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "averaged_pressure_force", {Paper::adams2009, "Sec. 6.1"},
        [] { return net_force_of<D>(TaitPressure{equation}, averaged<D>()); },
        [] { return net_force_of<D>(with_one_density<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "averaged_pressure_force", {Paper::adams2009, "Sec. 6.1"},
        [] { return net_torque_of<D>(TaitPressure{equation}, averaged<D>()); },
        [] { return net_torque_of<D>(with_one_density<D>()); });
})};
const Register erratum_of_average{Erratum{
    61,
    {Paper::adams2009, "Sec. 6.1"},
    "the simple way to make Eq. 50 symmetric: aᵢⱼ = −mⱼ (pᵢ + pⱼ)/(2ρⱼ) ∇ω",
    "no 1/2, and ρᵢ ρⱼ: Σⱼ mⱼ/ρⱼ pᵢ ∇ω is 0 where samples are regular, so the half of pⱼ is "
    "half of the force"}};
}  // namespace
}  // namespace averaged_pressure_force_claims
