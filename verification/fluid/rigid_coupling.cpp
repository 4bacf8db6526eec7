#include "solver/fluid/rigid_coupling.h"

#include "solver/fluid/ghost_pressure_force.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/jittered.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace rigid_coupling_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double h = 2.6, edge = 8.0, depth_of_middle = 20.0;
template <int Dim> using W = WendlandC2<Dim>;

/// Fluid of density 1 in a box, at rest under gravity 1, with a block of 8 spacings in its middle that is a body,
/// made of ghosts; kernels of `support` for what the body feels.
template <int Dim> auto block_in_fluid(double jitter, double support) {
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, Masses, Density, Pressure>{},
                Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses, BodyOfGhost,
                      PlaceInBody<Dim>>{},
                FindGhosts<Dim, CellGrid<Dim>>{h}, GhostPressureForce<W<Dim>>{W<Dim>(h)},
                PressureOnBodies<W<Dim>>{W<Dim>(support)}};
    const auto around = Vec<Dim>::Constant(0.5 * edge + 4.0);
    RigidBody<Dim> body;
    body.centre = Vec<Dim>::Constant(0.3);
    scene.template get<RigidBodies<Dim>>().all = {body};
    for (const Vec<Dim>& x : jittered<Dim>({-around, around}, 1.0, jitter, 1)) {
        if (x.cwiseAbs().maxCoeff() < 0.5 * edge) {
            scene.template get<GhostPositions<Dim>>().push_back(x);
            scene.template get<PlaceInBody<Dim>>().push_back(x - body.centre);
        } else {
            scene.template get<Positions<Dim>>().push_back(x);
            scene.template get<Pressure>().push_back(depth_of_middle - x[Dim - 1]);
        }
    }
    const std::size_t n = scene.template get<Positions<Dim>>().size();
    const std::size_t ghosts = scene.template get<GhostPositions<Dim>>().size();
    scene.template get<Velocities<Dim>>().assign(n, Vec<Dim>::Zero());
    scene.template get<Masses>().assign(n, 1.0);
    scene.template get<Density>().assign(n, 1.0);
    scene.template get<GhostVelocities<Dim>>().assign(ghosts, Vec<Dim>::Zero());
    scene.template get<GhostMasses>().assign(ghosts, 1.0);
    scene.template get<BodyOfGhost>().assign(ghosts, 0);
    scene.step(0.0);
    return scene;
}
/// ‖Σ mᵢ aᵢ + F‖ / Σ mᵢ ‖aᵢ‖ or ‖Σ xᵢ × mᵢ aᵢ + T + X × F‖ / Σ ‖xᵢ‖ mᵢ ‖aᵢ‖, the larger.
template <int Dim> double lost_momentum(double support) {
    const auto scene = block_in_fluid<Dim>(0.2, support);
    const auto& x = scene.template get<Positions<Dim>>();
    const auto& a = scene.template get<Accelerations<Dim>>();
    const RigidBody<Dim>& body = scene.template get<RigidBodies<Dim>>().all[0];
    Vec<Dim> linear = body.force;
    Turn<Dim> angular = body.torque + cross_product<Dim>(body.centre, body.force);
    double p = 0.0, l = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        linear += a[i], p += a[i].norm();
        angular += cross_product<Dim>(x[i], a[i]), l += x[i].norm() * a[i].norm();
    }
    return std::max(linear.norm() / p, angular.norm() / l);
}
/// The lift of the block over the weight of the fluid that it displaces, on a lattice.
template <int Dim> double lift(double support) {
    const auto scene = block_in_fluid<Dim>(0.0, support);
    return scene.template get<RigidBodies<Dim>>().all[0].force[Dim - 1] / std::pow(edge, Dim);
}

/// A body that nothing but gravity moves, for 1000 steps: ‖Rᵀ R − I‖, or how far L is from what it was, over it.
template <int Dim> auto tumbling(double dt) {
    Scene scene{MoveBodies<Dim>{Vec<Dim>::Unit(0)}};
    RigidBody<Dim> body;
    for (int k = 0; k < turns<Dim>; ++k) {
        body.inertia(k, k) = 1.0 + 0.5 * k;
        body.spin[k] = 1.0 - 0.3 * k;
    }
    scene.template get<RigidBodies<Dim>>().all = {body};
    const int steps = static_cast<int>(std::lround(1.0 / dt));
    for (int n = 0; n < steps; ++n) scene.step(dt);
    return scene.template get<RigidBodies<Dim>>().all[0];
}
template <int Dim> double distance_from_rotation() {
    const Mat<Dim> R = tumbling<Dim>(1e-3).rotation;
    return (R.transpose() * R - Mat<Dim>::Identity()).norm();
}
/// The same if R + Δt ω × R is taken for the turned R.
double distance_of_sheared() {
    Mat<2> R = Mat<2>::Identity();
    for (int n = 0; n < 1000; ++n) R += 1e-3 * (Mat<2>() << 0.0, -1.0, 1.0, 0.0).finished() * R;
    return (R.transpose() * R - Mat<2>::Identity()).norm();
}
double change_of_angular_momentum(bool with_gyration) {
    const RigidBody<3> body = tumbling<3>(1e-3);
    const Mat<3> J = with_gyration
                         ? Mat<3>(body.rotation * body.inertia * body.rotation.transpose())
                         : body.inertia;
    const Vec<3> start(1.0, 0.7 * 1.5, 0.4 * 2.0);
    return (J * body.spin - start).norm() / start.norm();
}

const Register momentum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "rigid_coupling.gives_what_it_takes",
        .source = {Paper::adams2009, "Sec. 6.3"},
        .says =
            "linear and angular momentum of fluid and body together, per time, over the sum "
            "of the forces on particles; wrong: a kernel of another support for the "
            "body",
        .bound = at_most(1e-13,
                         "the same terms in other orders: up to 1000 particles near the "
                         "body, √1000 · 20 terms · 1.1e-16"),
        .measure = [] { return lost_momentum<D>(h); },
        .sabotaged = [] { return lost_momentum<D>(0.99 * h); }};
})};
const Register archimedes{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "rigid_coupling.archimedes",
        .source = {Paper::adams2009, "Sec. 6.3"},
        .says =
            "lift of a block of 8 spacings over the weight of the fluid it displaces; "
            "wrong: ghosts felt to half of the distance only",
        .bound = between(0.95, 1.0 + h / edge,
                         "ghosts have the pressure of the particle that feels them, up to h "
                         "off the block and about h/2 in the mean, at both ends: at most 1 "
                         "+ h/8; rows of a lattice for an integral over the support, 5 %"),
        .measure = [] { return lift<D>(h); },
        .sabotaged = [] { return lift<D>(0.5 * h); }};
})};
const Register rotation{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "rigid_coupling.turns_without_shear",
                 .source = {Paper::plumbline, "docstring of MoveBodies"},
                 .says = "‖RᵀR − I‖ after 1000 steps; with R + Δt ω × R the body grows",
                 .bound = at_most(1e-12, "1000 products of matrices, 9 roundings of 1.1e-16 each"),
                 .measure = distance_from_rotation<D>,
                 .sabotaged = distance_of_sheared};
})};
const Register tumble{Claim{
    .id = "rigid_coupling.tumbles",
    .source = {Paper::plumbline, "docstring of MoveBodies"},
    .says = "R J₀ Rᵀ ω of a body with three moments of inertia after 1 s without torque, steps of "
            "1 ms, over its start; wrong: J₀ for J",
    .bound = at_most(5e-3,
                     "first order: Δt times rates of ω of size 1 over 1 s, 1e-3, with "
                     "moments of inertia up to twice as large, and some"),
    .measure = [] { return change_of_angular_momentum(true); },
    .sabotaged = [] { return change_of_angular_momentum(false); }}};
}  // namespace
}  // namespace rigid_coupling_claims
