#include "solver/fluid/body_contact.h"

#include "solver/foundation/random.h"
#include "solver/scene/scene.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

#include <functional>

namespace body_contact_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> RigidBody<Dim> ball_of(double mass, double radius) {
    RigidBody<Dim> body;
    body.mass = mass;
    body.inertia *= (Dim == 2 ? 0.5 : 0.4) * mass * radius * radius;
    return body;
}
template <int Dim> RigidBody<Dim> box_of(double mass, const Vec<Dim>& edges) {
    RigidBody<Dim> body;
    body.mass = mass;
    if constexpr (Dim == 2)
        body.inertia *= mass / 12.0 * edges.squaredNorm();
    else
        for (int k = 0; k < 3; ++k)
            body.inertia(k, k) = mass / 12.0 * (edges.squaredNorm() - edges[k] * edges[k]);
    return body;
}
template <int Dim> Shape<Dim> ball_shape(double radius) {
    return Ball<Dim>{Vec<Dim>::Zero(), radius};
}
template <int Dim> Shape<Dim> box_shape(const Vec<Dim>& edges) {
    return Cuboid<Dim>{-0.5 * edges, 0.5 * edges};
}
/// Kick, contacts, drift, as often as there are steps.
template <int Dim>
void move(
    RigidBodies<Dim>& bodies, const CollideBodies<Dim>& contacts, const Vec<Dim>& gravity,
    double dt, int steps, const std::function<void()>& look = [] {}) {
    for (int n = 0; n < steps; ++n) {
        KickBodies<Dim>{gravity}.run(dt, bodies);
        contacts.run(dt, bodies);
        DriftBodies<Dim>{}.run(dt, bodies);
        look();
    }
}

/// Two balls of masses 1 and 3 and radii 0.5 and 0.3, the first one moving at speed 1 along x, its centre `beside` the
/// other's path; |difference| of the velocities after the collision from those of Newton's law with e, for a contact that
/// is `expected` beside the path.
template <int Dim>
double error_of_collision(double beside, double restitution, double e_expected, double expected) {
    CollideBodies<Dim> contacts{.restitution = restitution};
    RigidBodies<Dim> bodies;
    bodies.push_back(ball_of<Dim>(1.0, 0.5));
    bodies.push_back(ball_of<Dim>(3.0, 0.3));
    bodies[0].velocity = Vec<Dim>::Unit(0);
    bodies[1].centre = 1.5 * Vec<Dim>::Unit(0) + beside * Vec<Dim>::Unit(Dim - 1);
    for (const double radius : {0.5, 0.3})
        contacts.outlines.push_back(outline_of<Dim>(ball_shape<Dim>(radius)));
    move<Dim>(bodies, contacts, Vec<Dim>::Zero(), 1e-3, 1500);
    Vec<Dim> n =
        expected * Vec<Dim>::Unit(Dim - 1);  // from the first to the second where they touch
    n[0] = std::sqrt(0.64 - expected * expected);
    n.normalize();
    const double impulse = (1.0 + e_expected) * n[0] / (1.0 / 1.0 + 1.0 / 3.0);
    return std::max((bodies[0].velocity - (Vec<Dim>::Unit(0) - impulse * n)).norm(),
                    (bodies[1].velocity - impulse / 3.0 * n).norm());
}

/// Balls, in the plane also boxes, in a hollow box, at random speeds up to 1 and spins up to 2, for 2000 steps of 1 ms.
template <int Dim> struct Crowd {
    CollideBodies<Dim> contacts;
    RigidBodies<Dim> bodies;
    double deepest = -HUGE_VAL;

    Crowd(double restitution, double friction, bool walls)
        : contacts{.restitution = restitution, .friction = friction} {
        if (walls)
            contacts.obstacles =
                obstacles_of<Dim>(Cuboid<Dim>{Vec<Dim>::Zero(), Vec<Dim>::Constant(4.0)}, true);
        Random random(5);
        for (int k = 0; k < 1 << 2 * (Dim - 1); ++k) {
            const bool box = Dim == 2 && k % 2 == 1;
            Vec<Dim> edges = Vec<Dim>::Constant(0.5);
            edges[0] = 0.7;
            bodies.push_back(box ? box_of<Dim>(0.5 + k % 3, edges)
                                 : ball_of<Dim>(0.5 + k % 3, 0.4));
            contacts.outlines.push_back(
                outline_of<Dim>(box ? box_shape<Dim>(edges) : ball_shape<Dim>(0.4)));
            RigidBody<Dim>& body = bodies.back();
            for (int d = 0; d < Dim; ++d) {
                body.centre[d] = 0.5 + (k >> 2 * d) % 4;
                body.velocity[d] = random.uniform(-1.0, 1.0);
            }
            for (double& omega : body.spin) omega = random.uniform(-2.0, 2.0);
        }
    }
    void run(const Vec<Dim>& gravity) {
        move<Dim>(bodies, contacts, gravity, 1e-3, 2000,
                  [&] { deepest = std::max(deepest, deepest_overlap(contacts, bodies)); });
    }
    Vec<Dim> momentum() const {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (const auto& b : bodies) sum += b.mass * b.velocity;
        return sum;
    }
    Turn<Dim> angular_momentum() const {
        Turn<Dim> sum = Turn<Dim>::Zero();
        for (const auto& b : bodies)
            sum += b.mass * cross_product<Dim>(b.centre, b.velocity) + b.inertia_now() * b.spin;
        return sum;
    }
    double energy() const {
        double sum = 0.0;
        for (const auto& b : bodies)
            sum += 0.5 * b.mass * b.velocity.squaredNorm() +
                   0.5 * b.spin.dot(b.inertia_now() * b.spin);
        return sum;
    }
};
/// What a crowd that falls in on itself loses of its momenta, over sums of sizes at its start.
template <int Dim> double lost_momentum(bool some_are_immovable) {
    Crowd<Dim> crowd(0.7, 0.4, false);
    double p = 0.0;
    for (auto& b : crowd.bodies) {
        b.velocity -= 0.8 * (b.centre - Vec<Dim>::Constant(2.0));
        p += b.mass * b.velocity.norm();
    }
    const Vec<Dim> momentum = crowd.momentum();
    const Turn<Dim> angular = crowd.angular_momentum();
    const RigidBodies<Dim> start = crowd.bodies;
    for (std::size_t k = 0; k < start.size() && some_are_immovable; k += 3)
        crowd.bodies[k].mass = HUGE_VAL;
    crowd.run(Vec<Dim>::Zero());
    for (std::size_t k = 0; k < start.size(); ++k) crowd.bodies[k].mass = start[k].mass;
    return std::max((crowd.momentum() - momentum).norm() / p,
                    (crowd.angular_momentum() - angular).norm() / (3.0 * p));
}
template <int Dim> double deepest_in_crowd(bool collide) {
    Crowd<Dim> crowd(0.5, 0.3, true);
    if (!collide) crowd.contacts.obstacles.clear();
    crowd.run(Vec<Dim>(-2.0 * Vec<Dim>::Unit(Dim - 1)));
    crowd.contacts.obstacles = Crowd<Dim>(0.5, 0.3, true).contacts.obstacles;
    return std::max(crowd.deepest, deepest_overlap(crowd.contacts, crowd.bodies));
}

/// A box dropped flat onto a floor from 0.1 above it: how far it is from resting there after 2 s [m, m/s, 1/s].
template <int Dim> double error_of_rest(bool floor) {
    const Vec<Dim> edges = Vec<Dim>::Constant(0.5), up = Vec<Dim>::Unit(Dim - 1);
    CollideBodies<Dim> contacts{.outlines = {outline_of<Dim>(box_shape<Dim>(edges))}};
    if (floor) contacts.obstacles.push_back({HalfSpace<Dim>{Vec<Dim>::Zero(), up}});
    RigidBodies<Dim> bodies;
    bodies.push_back(box_of<Dim>(2.0, edges));
    bodies[0].centre = 0.35 * up;
    move<Dim>(bodies, contacts, Vec<Dim>(-10.0 * up), 1e-3, 2000);
    return std::abs(bodies[0].centre[Dim - 1] - 0.25) + bodies[0].velocity.norm() +
           bodies[0].spin.norm();
}
/// A box slides at speed 2 over a floor with friction μ = 0.25 under gravity 10: how far it is when it rests.
template <int Dim> double way_on_floor(double friction) {
    Vec<Dim> edges = Vec<Dim>::Constant(0.5);
    edges[Dim - 1] = 0.1;
    const Vec<Dim> up = Vec<Dim>::Unit(Dim - 1);
    const CollideBodies<Dim> contacts{.outlines = {outline_of<Dim>(box_shape<Dim>(edges))},
                                      .obstacles = {{HalfSpace<Dim>{Vec<Dim>::Zero(), up}}},
                                      .friction = friction};
    RigidBodies<Dim> bodies;
    bodies.push_back(box_of<Dim>(2.0, edges));
    bodies[0].centre = 0.05 * up;
    bodies[0].velocity = 2.0 * Vec<Dim>::Unit(0);
    move<Dim>(bodies, contacts, Vec<Dim>(-10.0 * up), 1e-3, 1500);
    return bodies[0].centre[0];
}

const Register head_on{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "body_contact.head_on",
                 .source = {Paper::literature, "Newton: v₁′ − v₂′ = −e (v₁ − v₂)"},
                 .says =
                     "velocities of two balls of masses 1 and 3 after a central collision with e "
                     "= 1 [m/s]; wrong: e = 0.9",
                 .bound = at_most(1e-14, "some ten roundings of numbers below 1, 1.1e-16 each"),
                 .measure = [] { return error_of_collision<Dim>(0.0, 1.0, 1.0, 0.0); },
                 .sabotaged = [] { return error_of_collision<Dim>(0.0, 0.9, 1.0, 0.0); }};
})};
const Register oblique{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "body_contact.oblique",
                 .source = {Paper::literature, "Newton: v₁′ − v₂′ = −e (v₁ − v₂)"},
                 .says =
                     "the same 0.4 beside the centre, at 30 degrees, with e = 0.5; wrong: as if "
                     "it were central",
                 .bound = at_most(7.1e-4,
                                  "the normal is taken up to 1 ms before the contact: off by an "
                                  "angle of 1e-3 · sin 30° / 0.8; impulses of 1.5 · 0.75 (n·u) n "
                                  "change by 1.125 of it"),
                 .measure = [] { return error_of_collision<Dim>(0.4, 0.5, 0.5, 0.4); },
                 .sabotaged = [] { return error_of_collision<Dim>(0.4, 0.5, 0.5, 0.0); }};
})};
const Register momenta{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "body_contact.keeps_momenta",
        .source = {Paper::plumbline, "docstring of CollideBodies"},
        .says =
            "linear and angular momentum of a crowd of balls, in the plane also boxes, "
            "with e = 0.7 and friction 0.4, after 2000 steps, over their start; wrong: "
            "nothing moves every third of them",
        .bound = at_most(1e-12,
                         "at most some ten contacts of 64 bodies, of up to 200 sweeps each, "
                         "√(1e5) roundings of 1.1e-16 of impulses below 1/10 of all, and "
                         "some 10"),
        .measure = [] { return lost_momentum<Dim>(false); },
        .sabotaged = [] { return lost_momentum<Dim>(true); }};
})};
const Register overlaps{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "body_contact.bodies_stay_apart",
        .source = {Paper::plumbline, "docstring of CollideBodies"},
        .says =
            "deepest overlap in a crowd of balls, in the plane also boxes, that falls and comes "
            "to rest in a hollow box, 2000 steps [m]; wrong: walls have no effect",
        .bound =
            at_most(Dim == 2 ? 1e-4 : 1e-9,
                    Dim == 2 ? "r (5/2) (Δt ω)² with r = 0.43, Δt = 1 ms and ω up to 9, as of a "
                               "box that a collision at relative speed 2 at its end turns: 0.9e-4"
                             : "balls do not go in by turning: what 200 sweeps leave of a speed "
                               "of 1e-3, over 1 ms, is below 1e-9"),
        .measure = [] { return deepest_in_crowd<Dim>(true); },
        .sabotaged = [] { return deepest_in_crowd<Dim>(false); }};
})};
const Register rest{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "body_contact.rests_on_a_floor",
        .source = {Paper::plumbline, "docstring of CollideBodies"},
        .says =
            "a box dropped flat on a floor with e = 0: how far it is from resting on it, "
            "place, speed and spin; wrong: no floor",
        .bound = at_most(1e-11,
                         "each step brings 0.01 m/s, of which sweeps leave 1e-14 over four "
                         "corners, in place 1e-16 over 1 ms, five times that"),
        .measure = [] { return error_of_rest<Dim>(true); },
        .sabotaged = [] { return error_of_rest<Dim>(false); }};
})};
const Register way{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "body_contact.slides_to_rest",
        .source = {Paper::literature, "Coulomb: v²/(2 μ g)"},
        .says =
            "the way of a box that slides over a floor at speed 2 with friction 0.25 "
            "under gravity 10 until it rests [m]; wrong: friction 0.3",
        .bound = between(0.8 - 2.1e-3, 0.8 + 2.1e-3,
                         "4/(2 · 2.5) m; steps of 1 ms take the speed of their end: 2 · "
                         "1e-3/2, and the last one is cut short; as much again for corners "
                         "that share the load in turns"),
        .measure = [] { return way_on_floor<Dim>(0.25); },
        .sabotaged = [] { return way_on_floor<Dim>(0.3); }};
})};
}  // namespace
}  // namespace body_contact_claims
