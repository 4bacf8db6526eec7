#include "solver/scene/enforce_constraints.h"

#include "verification/framework/in_dimensions.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"

namespace enforce_constraints_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The corner of a room: walls across all axes, at 0.
template <int Dim> std::vector<HalfSpace<Dim>> corner() {
    std::vector<HalfSpace<Dim>> walls;
    for (int d = 0; d < Dim; ++d) walls.push_back({Vec<Dim>::Zero(), Vec<Dim>::Unit(d)});
    return walls;
}
template <int Dim> struct Particle {
    Positions<Dim> x;
    Velocities<Dim> v;
};
template <int Dim> Particle<Dim> any_particle() {
    Particle<Dim> p;
    p.x.push_back(point<Dim>(-1.0, 1.0));
    p.v.push_back(point<Dim>(-1.0, 1.0));
    return p;
}

/// How far a particle is behind a wall, or still moves into one that it was behind [m, m/s].
template <int Dim> double left_over(double sign) {
    return worst_error([=] {
        Particle<Dim> p = any_particle<Dim>();
        const Vec<Dim> before = p.x[0];
        auto walls = corner<Dim>();
        for (HalfSpace<Dim>& wall : walls) wall.n *= sign;
        EnforceConstraints<Dim>{walls}.run(0.0, p.x, p.v);
        double worst = 0.0;
        for (int d = 0; d < Dim; ++d) {
            worst = std::max(worst, -p.x[0][d]);
            if (before[d] < 0.0) worst = std::max(worst, -p.v[0][d]);
        }
        return worst;
    });
}
/// |‖v‖ − ‖v before‖| with e = 1 [m/s].
template <int Dim> double change_of_speed(double restitution) {
    return worst_error([=] {
        Particle<Dim> p = any_particle<Dim>();
        const double speed = p.v[0].norm();
        EnforceConstraints<Dim>{corner<Dim>(), restitution}.run(0.0, p.x, p.v);
        return p.v[0].norm() - speed;
    });
}

const Register nothing_behind_walls{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "enforce_constraints.nothing_behind_walls",
                 .source = {Paper::adams2009, "Alg. 5"},
                 .says =
                     "in a corner no particle is left behind a wall, nor moves on into one that it "
                     "was behind; not if normals point the wrong way",
                 .bound = at_most(0.0, "walls across the axes change one component each, to 0"),
                 .measure = [] { return left_over<Dim>(1.0); },
                 .sabotaged = [] { return left_over<Dim>(-1.0); }};
})};
const Register elastic{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "enforce_constraints.elastic",
                 .source = {Paper::plumbline, "docstring of EnforceConstraints"},
                 .says = "with e = 1 no speed changes; with e = 0 it does",
                 .bound = at_most(1e-15,
                                  "one rounding of each of at most 3 components below 1, and of "
                                  "two norms: 5 · 1.1e-16, doubled by the factor 2"),
                 .measure = [] { return change_of_speed<Dim>(1.0); },
                 .sabotaged = [] { return change_of_speed<Dim>(0.0); }};
})};
}  // namespace
}  // namespace enforce_constraints_claims
