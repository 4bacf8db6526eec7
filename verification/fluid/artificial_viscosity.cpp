#include "solver/fluid/artificial_viscosity.h"

#include "solver/fluid/monaghan_viscosity.h"
#include "verification/fluid/force_claims.h"
#include "verification/fluid/pair_force.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace artificial_viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr std::string_view literature = "Monaghan 1992";
template <int Dim> using W = WendlandC2<Dim>;
template <int Dim> ArtificialViscosity<W<Dim>> artificial(double alpha = 0.1) {
    return {W<Dim>(Drop<Dim>::support), alpha, 10.0};
}
/// α c h μᵢⱼ times 1/ρᵢ, where the mean of the densities belongs; or without the switch.
template <int Dim> auto with_own_density() {
    return PairForce<Dim>([w = W<Dim>(Drop<Dim>::support)](Index i, const Neighbour<Dim>& n,
                                                           const PairState<Dim>& s) {
        const double approach = std::min(0.0, (s.v[i] - s.v[n.j]).dot(n.x));
        return Vec<Dim>(s.m[n.j] * approach / s.rho[i] * gradient(w, n));
    });
}
template <int Dim> auto along_the_velocity() {
    return PairForce<Dim>([w = W<Dim>(Drop<Dim>::support)](Index i, const Neighbour<Dim>& n,
                                                           const PairState<Dim>& s) {
        return Vec<Dim>(s.m[n.j] * w.value(n.r) * (s.v[n.j] - s.v[i]));
    });
}
template <int Dim> auto of_neighbours_alone() {
    return PairForce<Dim>(
        [w = W<Dim>(Drop<Dim>::support)](Index, const Neighbour<Dim>& n, const PairState<Dim>& s) {
            return Vec<Dim>(s.m[n.j] * s.v[n.j].dot(n.x) * gradient(w, n));
        });
}
/// ‖a‖ of a drop that blows up, v = x, over that of one that collapses.
template <int Dim, class Force> double braking_of_an_explosion(Force force) {
    const auto size = [&](double rate) {
        Drop<Dim> drop;
        for (std::size_t i = 0; i < drop.x.size(); ++i) drop.v[i] = rate * drop.x[i];
        double largest = 0.0;
        const auto scene = evaluated<Dim>(drop, force);
        for (const auto& a : scene.template get<Accelerations<Dim>>())
            largest = std::max(largest, a.norm());
        return largest;
    };
    return size(1.0) / size(-1.0);
}

const Register linear{in_dimensions<2, 3>([]<int D>() {
    return linear_momentum(
        "artificial_viscosity", {Paper::literature, literature},
        [] { return net_force_of<D>(artificial<D>()); },
        [] { return net_force_of<D>(with_own_density<D>()); });
})};
const Register angular{in_dimensions<2, 3>([]<int D>() {
    return angular_momentum(
        "artificial_viscosity", {Paper::literature, literature},
        [] { return net_torque_of<D>(artificial<D>()); },
        [] { return net_torque_of<D>(along_the_velocity<D>()); });
})};
const Register frames{in_dimensions<2, 3>([]<int D>() {
    return galilean(
        "artificial_viscosity", {Paper::literature, literature},
        [] { return change_in_moving_frame<D>(artificial<D>()); },
        [] { return change_in_moving_frame<D>(of_neighbours_alone<D>()); });
})};
const Register energy{in_dimensions<2, 3>([]<int D>() {
    return dissipative(
        "artificial_viscosity", {Paper::literature, literature},
        [] { return power_of<D>(artificial<D>()); },
        [] { return power_of<D>(artificial<D>(-0.1)); });
})};
const Register switched{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "artificial_viscosity.leaves_expansion_alone",
                 .source = {Paper::literature, literature},
                 .says = "a drop that expands, v = x, is not braked",
                 .bound = at_most(0.0, "xᵢⱼ·xᵢⱼ ≥ 0: every pair is left out"),
                 .measure = [] { return braking_of_an_explosion<D>(artificial<D>()); },
                 .sabotaged =
                     [] {
                         return braking_of_an_explosion<D>(
                             MonaghanViscosity<W<D>>{W<D>(Drop<D>::support), 1.0});
                     }};
})};
}  // namespace
}  // namespace artificial_viscosity_claims
