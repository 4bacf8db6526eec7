#include "solver/fluid/plain_pressure_force.h"

#include "solver/approximation/sph_gradient.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace plain_pressure_force_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
const TaitPressure tait{TaitEquation(1.0, 10.0, 7.0)};
template <int Dim> PlainPressureForce<W<Dim>> plain() { return {W<Dim>(Drop<Dim>::support)}; }
template <int Dim> PressureForce<W<Dim>> symmetric() { return {W<Dim>(Drop<Dim>::support)}; }

/// max ‖a + ∇p/ρ‖ / max ‖a‖ with the gradient of Eq. 9.
template <int Dim, class Force> double difference_from_eq_9(Force force) {
    const auto scene = evaluated<Dim>(Drop<Dim>{}, tait, force);
    const auto& x = scene.template get<Positions<Dim>>();
    const auto& m = scene.template get<Masses>();
    const auto& rho = scene.template get<Density>();
    const auto& p = scene.template get<Pressure>();
    std::vector<double> V;
    for (std::size_t i = 0; i < x.size(); ++i) V.push_back(m[i] / rho[i]);
    const W<Dim> w(Drop<Dim>::support);
    const Samples<Dim> samples{x, V, scene.template get<Neighbourhood<Dim>>().lists};
    Points<Dim> expected;
    for (Index i = 0; i < x.size(); ++i)
        expected.push_back(-gradient_summation<W<Dim>>(w, samples, p, samples.at(i)) / rho[i]);
    return largest_difference<Dim>(scene.template get<Accelerations<Dim>>(), expected);
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "plain_pressure_force.is_eq_9",
                 .source = {Paper::adams2009, "Eqs. 9, 45, 49, 50"},
                 .says = "a = −∇p/ρ with the gradient of Eq. 9",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return difference_from_eq_9<D>(plain<D>()); },
                 .sabotaged = [] { return difference_from_eq_9<D>(symmetric<D>()); }};
})};
const Register loses{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "plain_pressure_force.loses_momentum",
        .source = {Paper::adams2009, "Eq. 50; Sec. 6.1"},
        .says = "‖Σ mᵢ aᵢ‖ / Σ mᵢ ‖aᵢ‖: \"no guarantee that the pairwise influences cancel\"",
        .bound = at_least(1e-3, "rounding would be 1e-14: it is not conserved"),
        .measure = [] { return net_force_of<D>(tait, plain<D>()); },
        .sabotaged = [] { return net_force_of<D>(tait, symmetric<D>()); }};
})};
}  // namespace
}  // namespace plain_pressure_force_claims
