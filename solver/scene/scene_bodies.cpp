#include "solver/scene/scene_bodies.h"

#include "solver/particles/lattice.h"
#include "solver/particles/moments.h"
#include "solver/scene/start.h"

namespace plumbline {

namespace {
template <int Dim> Turn<Dim> spin_of(const Vec<3>& spin) {
    if constexpr (Dim == 2)
        return Turn<2>(spin[2]);
    else
        return spin;
}
/// tr(C) − C, C the second moments of the mass; in the plane tr(C).
template <int Dim> Inertia<Dim> inertia_of(const Mat<Dim>& second) {
    if constexpr (Dim == 2)
        return Inertia<2>(second.trace());
    else
        return second.trace() * Mat<3>::Identity() - second;
}
template <int Dim> Box<Dim> around(const SceneBody& body) {
    const Shape<Dim> shape = shape_of<Dim>(body.shape);
    if (const auto* box = std::get_if<Cuboid<Dim>>(&shape)) return {box->low, box->high};
    if (const auto* ball = std::get_if<Ball<Dim>>(&shape)) {
        const auto reach = Vec<Dim>::Constant(ball->radius);
        return {ball->centre - reach, ball->centre + reach};
    }
    if constexpr (Dim == 3)
        if (const auto* solid = std::get_if<MeshSolid>(&shape)) return solid->mesh->bounds();
    throw InvalidInput(body.place + ": expected a shape that ends somewhere, found a half-space");
}
}  // namespace

template <int Dim> BodyAtStart<Dim> body_at_start(const SceneBody& given) {
    const Shape<Dim> shape = shape_of<Dim>(given.shape);
    const Moments<Dim> moments = moments_of<Dim>(shape);
    BodyAtStart<Dim> start{{}, outline_of<Dim>(moved<Dim>(shape, -moments.centre))};
    RigidBody<Dim>& body = start.body;
    body.centre = moments.centre;
    body.velocity = given.velocity.template head<Dim>();
    body.spin = spin_of<Dim>(given.spin);
    body.mass = given.fixed        ? HUGE_VAL
                : given.mass > 0.0 ? given.mass
                                   : given.density * moments.volume;
    if (!given.fixed) body.inertia = inertia_of<Dim>(body.mass / moments.volume * moments.second);
    return start;
}

template <int Dim> Points<Dim> ghosts_of(const SceneBody& body, double spacing, int layers) {
    const Box<Dim> exact = around<Dim>(body);
    Box<Dim> box = exact;
    for (int k = 0; k < Dim; ++k) {
        const double cells = exact.size()[k] / spacing;
        if (body.shape.form == SolidShape::Form::box && std::abs(cells - std::round(cells)) > 1e-6)
            throw InvalidInput(body.place +
                               ": expected a box whose edges are multiples of the "
                               "spacing " +
                               std::to_string(spacing) + ", found " +
                               std::to_string(exact.size()[k]));
        // An even number of cells about a ball's centre; half a cell more, against rounding.
        const double half = std::ceil(0.5 * cells - 1e-6);
        if (body.shape.form == SolidShape::Form::sphere)
            box.low[k] = 0.5 * (exact.low[k] + exact.high[k]) - half * spacing;
        box.high[k] = box.low[k] + (std::max(std::round(cells), 2.0 * half) + 0.5) * spacing;
    }
    const Shape<Dim> shape = shape_of<Dim>(body.shape);
    Points<Dim> ghosts;
    for (const Vec<Dim>& x : lattice<Dim>(box, spacing)) {
        const double depth = -from_surface<Dim>(shape, x).distance;
        if (depth > 0.0 && depth < layers * spacing) ghosts.push_back(x);
    }
    if (ghosts.empty())
        throw InvalidInput(body.place + ": expected a body with ghosts, found none of spacing " +
                           std::to_string(spacing) + " in it");
    return ghosts;
}

template <int Dim> CollideBodies<Dim> contacts_of(const SceneFile& scene) {
    CollideBodies<Dim> contacts{.restitution = scene.body_restitution,
                                .friction = scene.body_friction};
    for (const SceneBody& body : scene.bodies)
        contacts.outlines.push_back(body_at_start<Dim>(body).outline);
    for (const Constraint<Dim>& c : solids_of<Dim>(scene))
        for (const Obstacle<Dim>& o : obstacles_of<Dim>(c.shape, c.hollow))
            contacts.obstacles.push_back(o);
    return contacts;
}

template <int Dim>
void require_bodies_apart(const SceneFile& scene, const CollideBodies<Dim>& contacts) {
    RigidBodies<Dim> bodies;
    // Tips miss boxes that cross with their edges on one line; ghosts do not.
    const auto reaches_into = [&](const SceneBody& one, const SceneBody& other) {
        const Shape<Dim> shape = shape_of<Dim>(other.shape);
        return std::ranges::any_of(
            ghosts_of<Dim>(one, scene.spacing, scene.wall_layers),
            [&](const Vec<Dim>& x) { return from_surface<Dim>(shape, x).distance < 0.0; });
    };
    for (const SceneBody& body : scene.bodies) {
        bool overlaps = false;
        for (std::size_t k = 0; k < bodies.size(); ++k)
            overlaps = overlaps || reaches_into(body, scene.bodies[k]) ||
                       reaches_into(scene.bodies[k], body);
        bodies.push_back(body_at_start<Dim>(body).body);
        CollideBodies<Dim> so_far = contacts;
        so_far.outlines.resize(bodies.size(), contacts.outlines[0]);
        if (overlaps || deepest_overlap<Dim>(so_far, bodies) > 1e-9 * scene.spacing)
            throw InvalidInput(body.place +
                               ": expected bodies that do not overlap each other, nor reach into "
                               "walls, found one that does");
    }
}

template BodyAtStart<2> body_at_start<2>(const SceneBody&);
template BodyAtStart<3> body_at_start<3>(const SceneBody&);
template Points<2> ghosts_of<2>(const SceneBody&, double, int);
template Points<3> ghosts_of<3>(const SceneBody&, double, int);
template CollideBodies<2> contacts_of<2>(const SceneFile&);
template CollideBodies<3> contacts_of<3>(const SceneFile&);
template void require_bodies_apart<2>(const SceneFile&, const CollideBodies<2>&);
template void require_bodies_apart<3>(const SceneFile&, const CollideBodies<3>&);

}  // namespace plumbline
