#include "solver/scene/enforce_constraints.h"

#include "solver/foundation/random.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"

namespace enforce_constraints_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The corner of a room: walls across all axes, at 0.
template <int Dim> std::vector<Constraint<Dim>> corner(double sign, double restitution) {
    std::vector<Constraint<Dim>> walls;
    for (int d = 0; d < Dim; ++d)
        walls.push_back({.shape = HalfSpace<Dim>{Vec<Dim>::Zero(), sign * Vec<Dim>::Unit(d)},
                         .restitution = restitution});
    return walls;
}
template <int Dim> struct Particle {
    Masses m;
    Positions<Dim> x;
    Velocities<Dim> v;
    TakenBySolids taken;
};
template <int Dim> Particle<Dim> any_particle() {
    Particle<Dim> p;
    p.m.push_back(1.0);
    p.x.push_back(point<Dim>(-1.0, 1.0));
    p.v.push_back(point<Dim>(-1.0, 1.0));
    return p;
}

/// How far a particle is behind a wall, or still moves into one that it was behind [m, m/s].
template <int Dim> double left_over(double sign) {
    return worst_error([=] {
        Particle<Dim> p = any_particle<Dim>();
        const Vec<Dim> before = p.x[0];
        EnforceConstraints<Dim>{corner<Dim>(sign, 0.0)}.run(0.0, p.m, p.x, p.v, p.taken);
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
        EnforceConstraints<Dim>{corner<Dim>(1.0, restitution)}.run(0.0, p.m, p.x, p.v, p.taken);
        return p.v[0].norm() - speed;
    });
}

/// An octahedron around `centre`.
std::shared_ptr<const ClosedMesh> octahedron(const Vec<3>& centre, double radius) {
    TriangleMesh mesh;
    for (int d = 0; d < 3; ++d)
        for (const double sign : {1.0, -1.0})
            mesh.vertices.push_back(centre + sign * radius * Vec<3>::Unit(d));
    for (const Index i : {0u, 1u})
        for (const Index j : {2u, 3u})
            for (const Index k : {4u, 5u}) mesh.triangles.push_back({i, j, k});
    return std::make_shared<const ClosedMesh>(mesh);
}
/// The inside of a box 4 wide, cut by a plane, with a ball, a box and in space an octahedron in it, apart from
/// each other.
template <int Dim> std::vector<Constraint<Dim>> room(double restitution, double friction) {
    const auto at = [](double a, double b) {
        Vec<Dim> x = Vec<Dim>::Constant(b);
        x[0] = a;
        return x;
    };
    std::vector<Shape<Dim>> shapes{Cuboid<Dim>{Vec<Dim>::Constant(-2.0), Vec<Dim>::Constant(2.0)},
                                   Ball<Dim>{at(0.9, 0.2), 0.6},
                                   Cuboid<Dim>{at(-1.2, -0.6), at(-0.4, 0.4)},
                                   HalfSpace<Dim>{at(-1.9, -1.9), at(1.0, 1.0).normalized()}};
    if constexpr (Dim == 3) shapes.push_back(MeshSolid{octahedron({0.2, 1.5, -1.0}, 0.4)});
    std::vector<Constraint<Dim>> all;
    for (const Shape<Dim>& shape : shapes)
        all.push_back({.shape = shape,
                       .hollow = all.empty(),
                       .restitution = restitution,
                       .friction = friction});
    return all;
}

struct Shots {
    double deepest = 0.0;  // in a solid, after any step [m]
    double energy = 0.0;   // |change of the kinetic energy| over its start
    double lost = 0.0;     // |change of momentum or energy| that no solid took over, over the start
};
struct How {
    double restitution = 0.0, friction = 0.0;
    bool positions_last = false, equal_masses = false;
};
/// 200 particles, shot from one place in all directions at speeds up to 2, for 300 steps of 0.01.
template <int Dim> Shots shots(const How& how) {
    const EnforceConstraints<Dim> enforce{room<Dim>(how.restitution, how.friction)};
    const Masses ones = [] {
        Masses m;
        m.assign(200, 1.0);
        return m;
    }();
    Random random(11);
    Particle<Dim> p;
    double energy = 0.0, momentum_of_all = 0.0;
    Vec<Dim> momentum = Vec<Dim>::Zero();
    for (int i = 0; i < 200; ++i) {
        Vec<Dim> v;
        for (int d = 0; d < Dim; ++d) v[d] = random.uniform(-1.0, 1.0);
        p.m.push_back(random.uniform(0.5, 1.5));
        p.x.push_back(Vec<Dim>::Constant(-0.9));
        p.v.push_back(v);
        energy += 0.5 * p.m.back() * v.squaredNorm();
        momentum += p.m.back() * v, momentum_of_all += p.m.back() * v.norm();
    }
    Shots found;
    for (int step = 0; step < 300; ++step) {
        const auto move = [&] {
            for (std::size_t i = 0; i < p.x.size(); ++i) p.x[i] += 0.01 * p.v[i];
        };
        if (!how.positions_last) move();
        enforce.run(0.01, how.equal_masses ? ones : p.m, p.x, p.v, p.taken);
        if (how.positions_last) move();
        for (const Constraint<Dim>& c : enforce.constraints)
            for (const Vec<Dim>& x : p.x)
                found.deepest = std::max(found.deepest, (c.hollow ? 1.0 : -1.0) *
                                                            from_surface<Dim>(c.shape, x).distance);
    }
    double end = 0.0;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        end += 0.5 * p.m[i] * p.v[i].squaredNorm();
        momentum -= p.m[i] * p.v[i];
    }
    for (int d = 0; d < Dim; ++d) momentum[d] -= p.taken.momentum[d];
    found.energy = std::abs(end - energy) / energy;
    found.lost = std::max(momentum.norm() / momentum_of_all,
                          std::abs(end + p.taken.energy - energy) / energy);
    return found;
}

/// Down a slope of 30 degrees for 1000 steps of 1 ms under gravity 10: the speed, over what is left of g t sin 30°.
template <int Dim> double speed_on_slope(double friction) {
    Vec<Dim> n = Vec<Dim>::Zero(), g = Vec<Dim>::Zero();
    n[0] = 0.5, n[Dim - 1] = std::sqrt(0.75), g[Dim - 1] = -10.0;
    Particle<Dim> p;
    p.m.push_back(2.0), p.x.push_back(Vec<Dim>::Zero()), p.v.push_back(Vec<Dim>::Zero());
    const EnforceConstraints<Dim> slope{
        {{.shape = HalfSpace<Dim>{Vec<Dim>::Zero(), n}, .friction = friction}}};
    for (int step = 0; step < 1000; ++step) {
        p.v[0] += 1e-3 * g;
        p.x[0] += 1e-3 * p.v[0];
        slope.run(1e-3, p.m, p.x, p.v, p.taken);
    }
    return p.v[0].norm() / 5.0;
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
const Register no_shot_ends_inside{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "enforce_constraints.no_shot_ends_in_a_solid",
        .source = {Paper::plumbline, "docstring of EnforceConstraints"},
        .says =
            "depth of 200 particles that bounce about 300 steps in a box with a plane, a "
            "ball, a box, in space a mesh [m]; wrong: positions advance after it",
        .bound = at_most(1e-14,
                         "the foot on a surface is off by the rounding of numbers up to 2 "
                         "in some ten operations, 4e-16 each"),
        .measure = [] { return shots<Dim>({.restitution = 0.5}).deepest; },
        .sabotaged =
            [] { return shots<Dim>({.restitution = 0.5, .positions_last = true}).deepest; }};
})};
const Register shots_are_elastic{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "enforce_constraints.shots_keep_their_energy",
        .source = {Paper::plumbline, "docstring of rebound"},
        .says =
            "kinetic energy after the same shots with e = 1 and no friction, change over "
            "its start; with friction 0.1 some is lost",
        .bound = at_most(1e-13,
                         "a particle at speed 1 crosses 4 in 400 steps: at most some ten "
                         "bounces between near solids, ten roundings of 1.1e-16 each"),
        .measure = [] { return shots<Dim>({.restitution = 1.0}).energy; },
        .sabotaged = [] { return shots<Dim>({.restitution = 1.0, .friction = 0.1}).energy; }};
})};
const Register solids_take_over{in_dimensions<2, 3>([]<int Dim>() {
    const How how{.restitution = 0.5, .friction = 0.3};
    How equal = how;
    equal.equal_masses = true;
    return Claim{.id = "enforce_constraints.solids_take_what_particles_lose",
                 .source = {Paper::plumbline, "docstring of EnforceConstraints"},
                 .says =
                     "momentum and energy of the same shots with e = 0.5 and friction 0.3, and of "
                     "the solids, over their start; wrong: all particles as heavy as 1",
                 .bound = at_most(1e-13,
                                  "sums of up to 200 · 10 impulses of either sign, each rounded by "
                                  "1.1e-16 of a sum below 200, over some 100"),
                 .measure = [=] { return shots<Dim>(how).lost; },
                 .sabotaged = [=] { return shots<Dim>(equal).lost; }};
})};
const Register friction{in_dimensions<2, 3>([]<int Dim>() {
    const double left = 1.0 - 0.2 * std::sqrt(3.0);
    return Claim{
        .id = "enforce_constraints.friction_on_a_slope",
        .source = {Paper::literature, "Coulomb: g (sin θ − μ cos θ)"},
        .says =
            "speed of a particle on a slope of 30 degrees with μ = 0.2, over that of one "
            "without friction; wrong: no friction",
        .bound = between(left - 1e-12, left + 1e-12,
                         "1 − μ/tan 30°; 1000 steps, each rounded some ten times by 1.1e-16"),
        .measure = [] { return speed_on_slope<Dim>(0.2); },
        .sabotaged = [] { return speed_on_slope<Dim>(0.0); }};
})};
const Register sticking{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "enforce_constraints.friction_holds",
                 .source = {Paper::literature, "Coulomb: at rest where tan θ < μ"},
                 .says = "the same with μ = 0.58 > tan 30°: it stays; with μ = 0.57 it goes",
                 .bound = at_most(1e-12, "what is left of a speed of 1e-3 by rounding"),
                 .measure = [] { return speed_on_slope<Dim>(0.58); },
                 .sabotaged = [] { return speed_on_slope<Dim>(0.57); }};
})};
}  // namespace
}  // namespace enforce_constraints_claims
