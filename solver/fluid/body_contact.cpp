#include "solver/fluid/body_contact.h"

namespace plumbline {

namespace {
constexpr Index nobody = ~Index{0};

template <int Dim> struct Contact {
    Index a, b;                          // bodies; b may be nobody
    Vec<Dim> at;                         // [m]
    Vec<Dim> n;                          // from b towards a
    double gap;                          // φ [m]
    double least = 0.0;                  // that u·n is to be [m/s]
    double pushed = 0.0;                 // impulse along n so far [N s]
    Vec<Dim> rubbed = Vec<Dim>::Zero();  // impulse across n so far [N s]
};

/// The surface of a body at x.
template <int Dim>
FromSurface<Dim> from_body(const Outline<Dim>& outline, const RigidBody<Dim>& body,
                           const Vec<Dim>& x) {
    const auto at =
        from_surface<Dim>(outline.shape, Vec<Dim>(body.rotation.transpose() * (x - body.centre)));
    return {at.distance, body.rotation * at.normal};
}
template <int Dim>
FromSurface<Dim> from_obstacle(const Obstacle<Dim>& obstacle, const Vec<Dim>& x) {
    FromSurface<Dim> at = from_surface<Dim>(obstacle.shape, x);
    if (obstacle.hollow) return {-at.distance, -at.normal};
    return at;
}

/// Calls f(a, b, point of the tip, its gap, normal) for each tip of a body and what it may touch.
template <int Dim, class F>
void for_each_tip(const CollideBodies<Dim>& c, const RigidBodies<Dim>& bodies, F f) {
    const auto is_ball = [&](Index k) { return c.outlines[k].radius > 0.0; };
    for (Index a = 0; a < bodies.size(); ++a)
        for (const Vec<Dim>& tip : c.outlines[a].tips) {
            const Vec<Dim> x = bodies[a].centre + bodies[a].rotation * tip;
            const auto meet = [&](Index b, const FromSurface<Dim>& at) {
                const double radius = c.outlines[a].radius;
                f(a, b, Vec<Dim>(x - radius * at.normal), at.distance - radius, at.normal);
            };
            for (Index b = 0; b < bodies.size(); ++b) {
                if (b == a || (b < a && is_ball(a) && is_ball(b))) continue;  // two balls meet once
                meet(b, from_body<Dim>(c.outlines[b], bodies[b], x));
            }
            if (bodies[a].is_free())
                for (const Obstacle<Dim>& o : c.obstacles) meet(nobody, from_obstacle<Dim>(o, x));
        }
}

template <int Dim> class Impulses {
public:
    explicit Impulses(RigidBodies<Dim>& bodies) : bodies_{bodies} {
        for (const RigidBody<Dim>& body : bodies) inverse_.push_back(body.inverse_inertia());
    }
    /// Of a's surface relative to b's.
    Vec<Dim> velocity(const Contact<Dim>& c) const {
        Vec<Dim> u = bodies_[c.a].velocity_at(c.at);
        if (c.b != nobody) u -= bodies_[c.b].velocity_at(c.at);
        return u;
    }
    /// What an impulse of 1 along `direction` changes of that velocity in this direction [1/kg].
    double mobility(const Contact<Dim>& c, const Vec<Dim>& direction) const {
        double sum = 0.0;
        for (const Index k : {c.a, c.b}) {
            if (k == nobody) continue;
            const Turn<Dim> arm = cross_product<Dim>(Vec<Dim>(c.at - bodies_[k].centre), direction);
            sum += bodies_[k].inverse_mass() + arm.dot(inverse_[k] * arm);
        }
        return sum;
    }
    void apply(const Contact<Dim>& c, const Vec<Dim>& impulse) {
        give(c.a, c.at, impulse);
        if (c.b != nobody) give(c.b, c.at, -impulse);
    }

private:
    void give(Index k, const Vec<Dim>& at, const Vec<Dim>& impulse) {
        RigidBody<Dim>& body = bodies_[k];
        body.velocity += body.inverse_mass() * impulse;
        body.spin += inverse_[k] * cross_product<Dim>(Vec<Dim>(at - body.centre), impulse);
    }

    RigidBodies<Dim>& bodies_;
    std::vector<Inertia<Dim>> inverse_;
};

/// Along the normal; returns by how much the velocity there changed.
template <int Dim> double push(Impulses<Dim>& impulses, Contact<Dim>& c) {
    const double mobility = impulses.mobility(c, c.n);
    const double missing = c.least - c.n.dot(impulses.velocity(c));
    const double pushed = std::max(0.0, c.pushed + missing / mobility);
    const double change = pushed - c.pushed;
    impulses.apply(c, Vec<Dim>(change * c.n));
    c.pushed = pushed;
    return std::abs(change) * mobility;
}
template <int Dim> double rub(Impulses<Dim>& impulses, Contact<Dim>& c, double friction) {
    const Vec<Dim> u = impulses.velocity(c);
    const Vec<Dim> sliding = u - c.n.dot(u) * c.n;
    const double speed = sliding.norm();
    if (speed == 0.0) return 0.0;
    const double mobility = impulses.mobility(c, Vec<Dim>(sliding / speed));
    Vec<Dim> rubbed = c.rubbed - sliding / mobility;
    const double most = friction * c.pushed;
    if (rubbed.norm() > most) rubbed *= most / rubbed.norm();
    const Vec<Dim> change = rubbed - c.rubbed;
    impulses.apply(c, change);
    c.rubbed = rubbed;
    return change.norm() * mobility;
}
}  // namespace

template <int Dim> Outline<Dim> outline_of(const Shape<Dim>& shape) {
    Outline<Dim> outline{shape, {}};
    if (const auto* ball = std::get_if<Ball<Dim>>(&shape)) {
        outline.tips = {ball->centre};
        outline.radius = ball->radius;
    } else if (const auto* box = std::get_if<Cuboid<Dim>>(&shape)) {
        for (int corner = 0; corner < 1 << Dim; ++corner) {
            outline.tips.push_back(box->low);
            for (int d = 0; d < Dim; ++d)
                if ((corner >> d & 1) != 0) outline.tips.back()[d] = box->high[d];
        }
    } else if (std::holds_alternative<HalfSpace<Dim>>(shape)) {
        throw InvalidInput("body: expected a shape that ends somewhere, found a half-space");
    }
    if constexpr (Dim == 3)
        if (const auto* solid = std::get_if<MeshSolid>(&shape))
            outline.tips = solid->mesh->triangles().vertices;
    return outline;
}

template <int Dim> std::vector<Obstacle<Dim>> obstacles_of(const Shape<Dim>& shape, bool hollow) {
    const auto* box = std::get_if<Cuboid<Dim>>(&shape);
    if (!hollow || box == nullptr) return {{shape, hollow}};
    std::vector<Obstacle<Dim>> sides;
    for (int d = 0; d < Dim; ++d) {
        sides.push_back({HalfSpace<Dim>{box->low, Vec<Dim>::Unit(d)}});
        sides.push_back({HalfSpace<Dim>{box->high, -Vec<Dim>::Unit(d)}});
    }
    return sides;
}

template <int Dim> void CollideBodies<Dim>::run(double dt, RigidBodies<Dim>& bodies) const {
    if (dt == 0.0) return;
    constexpr double taken_back = 0.2;  // of what a turn brought into a surface, per step
    constexpr int most_sweeps = 200;
    Impulses<Dim> impulses(bodies);
    std::vector<Contact<Dim>> contacts;
    double fastest = 0.0;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        fastest = std::max(fastest,
                           bodies[k].velocity.norm() + bodies[k].spin.norm() * outlines[k].reach());
    // What a push of this step drives together is in time, too: two bodies, and twice as fast at most.
    const double within = 4.0 * dt * fastest;
    for_each_tip<Dim>(*this, bodies,
                      [&](Index a, Index b, const Vec<Dim>& at, double gap, const Vec<Dim>& n) {
                          if (gap >= within) return;
                          Contact<Dim> c{a, b, at, n, gap};
                          if (impulses.mobility(c, n) == 0.0) return;
                          const double u = n.dot(impulses.velocity(c));
                          c.least = (gap > 0.0 ? -1.0 : -taken_back) * gap / dt;
                          if (restitution > 0.0 && gap + dt * u < 0.0 && u < 0.0)
                              c.least = std::max(c.least, -restitution * u);
                          contacts.push_back(c);
                      });
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double change = 0.0;
        for (Contact<Dim>& c : contacts) {
            change = std::max(change, push<Dim>(impulses, c));
            if (friction > 0.0) change = std::max(change, rub<Dim>(impulses, c, friction));
        }
        if (change <= 1e-14 * fastest) break;
    }
}

template <int Dim>
double deepest_overlap(const CollideBodies<Dim>& contacts, const RigidBodies<Dim>& bodies) {
    double deepest = -HUGE_VAL;
    for_each_tip<Dim>(contacts, bodies,
                      [&](Index, Index, const Vec<Dim>&, double gap, const Vec<Dim>&) {
                          deepest = std::max(deepest, -gap);
                      });
    return deepest;
}

template Outline<2> outline_of<2>(const Shape<2>&);
template Outline<3> outline_of<3>(const Shape<3>&);
template std::vector<Obstacle<2>> obstacles_of<2>(const Shape<2>&, bool);
template std::vector<Obstacle<3>> obstacles_of<3>(const Shape<3>&, bool);
template struct CollideBodies<2>;
template struct CollideBodies<3>;
template double deepest_overlap<2>(const CollideBodies<2>&, const RigidBodies<2>&);
template double deepest_overlap<3>(const CollideBodies<3>&, const RigidBodies<3>&);

}  // namespace plumbline
