#include "solver/fluid/rigid_body.h"

#include "solver/scene/scene.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace rigid_body_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// A body that nothing but gravity moves, for 1000 steps: ‖Rᵀ R − I‖, or how far L is from what it was, over it.
template <int Dim> auto tumbling(double dt) {
    Scene scene{KickBodies<Dim>{Vec<Dim>::Unit(0)}, DriftBodies<Dim>{}};
    RigidBody<Dim> body;
    for (int k = 0; k < turns<Dim>; ++k) {
        body.inertia(k, k) = 1.0 + 0.5 * k;
        body.spin[k] = 1.0 - 0.3 * k;
    }
    scene.template get<RigidBodies<Dim>>().push_back(body);
    const int steps = static_cast<int>(std::lround(1.0 / dt));
    for (int n = 0; n < steps; ++n) scene.step(dt);
    return scene.template get<RigidBodies<Dim>>()[0];
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

const Register rotation{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "rigid_body.turns_without_shear",
                 .source = {Paper::plumbline, "docstring of DriftBodies"},
                 .says = "‖RᵀR − I‖ after 1000 steps; with R + Δt ω × R the body grows",
                 .bound = at_most(1e-12, "1000 products of matrices, 9 roundings of 1.1e-16 each"),
                 .measure = distance_from_rotation<D>,
                 .sabotaged = distance_of_sheared};
})};
const Register tumble{Claim{
    .id = "rigid_body.tumbles",
    .source = {Paper::plumbline, "docstring of KickBodies"},
    .says = "R J₀ Rᵀ ω of a body with three moments of inertia after 1 s without torque, steps of "
            "1 ms, over its start; wrong: J₀ for J",
    .bound = at_most(5e-3,
                     "first order: Δt times rates of ω of size 1 over 1 s, 1e-3, with "
                     "moments of inertia up to twice as large, and some"),
    .measure = [] { return change_of_angular_momentum(true); },
    .sabotaged = [] { return change_of_angular_momentum(false); }}};
}  // namespace
}  // namespace rigid_body_claims
