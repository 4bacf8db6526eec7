#include "solver/fluid/cohesion.h"

#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

#include <numbers>

namespace cohesion_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> Cohesion<Dim> cohesion() { return {Drop<Dim>::support, 1.0, 1.0}; }
/// The density of the particle itself, not the mean of both, in the factor that makes up for missing
/// neighbours.
template <int Dim> PairForce<Dim> by_own_density() {
    return PairForce<Dim>([](Index i, const Neighbour<Dim>& n, const PairState<Dim>& s) {
        if (n.r == 0.0) return Vec<Dim>(Vec<Dim>::Zero());
        const double C = cohesion_of_distance(n.r, Drop<Dim>::support);
        return Vec<Dim>(-s.m[n.j] / s.rho[i] * C / n.r * n.x);
    });
}
/// Two particles, q of the support apart: the acceleration of the first towards the second.
double attraction(double q) {
    Drop<2> pair;
    pair.x = {Vec<2>::Zero(), q * Drop<2>::support * Vec<2>::Unit(0)};
    pair.v.assign(2, Vec<2>::Zero());
    pair.m.assign(2, 1.0);
    return evaluated<2>(pair, cohesion<2>()).get<Accelerations<2>>()[0][0];
}
/// max |C − Akinci's spline · 2π h³| for q from 0 to 1.2, C of the distance taken in units of `unit` supports.
double difference_from_print(double unit) {
    const double support = 1.7, pi = std::numbers::pi;
    double worst = 0.0;
    for (int k = 0; k <= 240; ++k) {
        const double r = 0.005 * k * support, d = support - r, h6 = std::pow(support, 6);
        double C = 32.0 / (pi * std::pow(support, 9));
        if (2.0 * r > support && r <= support)
            C *= d * d * d * r * r * r;
        else if (2.0 * r <= support)
            C *= 2.0 * d * d * d * r * r * r - h6 / 64.0;
        else
            C = 0.0;
        worst = std::max(worst, std::abs(cohesion_of_distance(unit * r, support) -
                                         C * 2.0 * pi * std::pow(support, 3)));
    }
    return worst;
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "cohesion", {Paper::literature, "Akinci et al. 2013"},
        [] { return net_force_of<D>(cohesion<D>()); },
        [] { return net_force_of<D>(by_own_density<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "cohesion", {Paper::literature, "Akinci et al. 2013"},
        [] { return net_torque_of<D>(cohesion<D>()); },
        [] { return net_torque_of<D>(by_own_density<D>()); });
})};
const Register spline{
    Claim{.id = "cohesion.is_the_printed_spline",
          .source = {Paper::literature, "Akinci et al. 2013, Eq. 2"},
          .says = "C(r) against the printed form, times 2π h³",
          .bound = at_most(4e-15,
                           "numbers up to 1, of at most 12 roundings in each form, twice that "
                           "where they are doubled: 36 · 1.1e-16"),
          .measure = [] { return difference_from_print(1.0); },
          .sabotaged = [] { return difference_from_print(0.5); }},
    Claim{.id = "cohesion.pulls_far_and_pushes_near",
          .source = {Paper::literature, "Akinci et al. 2013"},
          .says = "two particles at half of the support attract each other, at a tenth they repel: "
                  "the smaller of attraction and repulsion",
          .bound = at_least(1e-3, "rounding would be 1e-17"),
          .measure = [] { return std::min(attraction(0.5), -attraction(0.1)); },
          .sabotaged = [] { return std::min(attraction(0.5), -attraction(0.3)); }}};
}  // namespace
}  // namespace cohesion_claims
