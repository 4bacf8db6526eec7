#include "solver/fluid/continuity.h"

#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace continuity_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
template <int Dim> std::vector<double> rates(const Drop<Dim>& drop) {
    const auto scene = evaluated<Dim>(drop, Continuity<W<Dim>>{W<Dim>(Drop<Dim>::support)});
    return scene.template get<Rate<Density>>();
}
template <int Dim> std::vector<double> densities(const Drop<Dim>& drop) {
    return evaluated<Dim>(drop).template get<Density>();
}
double largest(const std::vector<double>& values) {
    double found = 0.0;
    for (const double value : values) found = std::max(found, std::abs(value));
    return found;
}
/// max |dρ/dt − difference of Eq. 5 along v| / max |dρ/dt|; `by_volume` has ρᵢ mⱼ/ρⱼ for mⱼ.
template <int Dim> double difference_from_eq_5(bool by_volume) {
    const Drop<Dim> drop;
    const auto moved = [&](double s) {
        Drop<Dim> d = drop;
        for (std::size_t i = 0; i < d.x.size(); ++i) d.x[i] += s * d.v[i];
        return densities(d);
    };
    const double s = 1e-3;
    const auto p = moved(s), q = moved(-s), pp = moved(2 * s), qq = moved(-2 * s);
    const auto found = rates(drop), rho = densities(drop);
    std::vector<double> by_solver = found;
    if (by_volume)
        for (std::size_t i = 0; i < rho.size(); ++i) by_solver[i] *= rho[i];
    double worst = 0.0;
    for (std::size_t i = 0; i < rho.size(); ++i) {
        const double slope = (8.0 * (p[i] - q[i]) - (pp[i] - qq[i])) / (12.0 * s);
        worst = std::max(worst, std::abs(by_solver[i] - slope));
    }
    return worst / largest(found);
}
/// max |dρ/dt| of a drop that spins, over that of random velocities; `expanding` adds v = x/100.
template <int Dim> double of_rigid_motion(bool expanding) {
    Drop<Dim> drop = spinning(Drop<Dim>{});
    if (expanding)
        for (std::size_t i = 0; i < drop.x.size(); ++i) drop.v[i] += 0.01 * drop.x[i];
    return largest(rates(drop)) / largest(rates(Drop<Dim>{}));
}

const Register derivative{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "continuity.is_the_rate_of_eq_5",
                 .source = {Paper::literature, "Monaghan 1992"},
                 .says = "dρ/dt is the derivative of the summed density along the velocities",
                 .bound = at_most(1e-7,
                                  "s⁴/30 of the fifth derivative, s = 1e-3; derivatives grow by "
                                  "at most 10 per order: 1e-12/30 · 1e4, rounding 1e-13/s"),
                 .measure = [] { return difference_from_eq_5<D>(false); },
                 .sabotaged = [] { return difference_from_eq_5<D>(true); }};
})};
const Register rigid{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "continuity.rigid_motion_keeps_densities",
                 .source = {Paper::literature, "Monaghan 1992"},
                 .says = "max |dρ/dt| of a drop in rigid motion, over that of random velocities",
                 .bound = at_most(1e-13,
                                  "v·x = (ω × x)·x = 0 but for roundings of v up to 8 to "
                                  "8.9e-16, ten such terms for velocities of size 1"),
                 .measure = [] { return of_rigid_motion<D>(false); },
                 .sabotaged = [] { return of_rigid_motion<D>(true); }};
})};
}  // namespace
}  // namespace continuity_claims
