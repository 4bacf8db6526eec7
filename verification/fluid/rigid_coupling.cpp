#include "solver/fluid/rigid_coupling.h"

#include "solver/fluid/ghost_pressure_force.h"
#include "solver/fluid/ghost_viscosity.h"
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
/// `More` passes come behind those of the pressure.
template <int Dim, class... More> auto block_in_fluid(double jitter, double support, More... more) {
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, Masses, Density, Pressure>{},
                Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses, BodyOfGhost,
                      PlaceInBody<Dim>>{},
                FindGhosts<Dim, CellGrid<Dim>>{h},
                GhostPressureForce<W<Dim>>{W<Dim>(h)},
                ForgetForces<Dim>{},
                PressureOnBodies<W<Dim>>{W<Dim>(support)},
                more...};
    const auto around = Vec<Dim>::Constant(0.5 * edge + 4.0);
    RigidBody<Dim> body;
    body.centre = Vec<Dim>::Constant(0.3);
    scene.template get<RigidBodies<Dim>>().push_back(body);
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
    for (const Vec<Dim>& x : scene.template get<Positions<Dim>>()) {
        Vec<Dim> v = x;  // of the fluid: sheared and turned
        v[0] = 0.5 * x[Dim - 1] - 0.2 * x[0];
        scene.template get<Velocities<Dim>>().push_back(v);
    }
    scene.template get<Masses>().assign(n, 1.0);
    scene.template get<Density>().assign(n, 1.0);
    scene.template get<GhostVelocities<Dim>>().assign(ghosts, Vec<Dim>::Zero());
    scene.template get<GhostMasses>().assign(ghosts, 1.0);
    scene.template get<BodyOfGhost>().assign(ghosts, 0);
    scene.step(0.0);
    return scene;
}
/// ‖Σ mᵢ aᵢ + F‖ / Σ mᵢ ‖aᵢ‖ or ‖Σ xᵢ × mᵢ aᵢ + T + X × F‖ / Σ ‖xᵢ‖ mᵢ ‖aᵢ‖, the larger.
template <int Dim, class... More> double lost_momentum(double support, More... more) {
    const auto scene = block_in_fluid<Dim>(0.2, support, more...);
    const auto& x = scene.template get<Positions<Dim>>();
    const auto& a = scene.template get<Accelerations<Dim>>();
    const RigidBody<Dim>& body = scene.template get<RigidBodies<Dim>>()[0];
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
    return scene.template get<RigidBodies<Dim>>()[0].force[Dim - 1] / std::pow(edge, Dim);
}

/// ViscosityOnBodies with the forces taken over at the ghosts.
template <RadialKernel K> struct ViscosityAtGhosts {
    static constexpr int dim = K::dim;
    using Reads = typename ViscosityOnBodies<K>::Reads;
    using Writes = Quantities<RigidBodies<dim>>;
    K w;
    double mu;

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const GhostPositions<dim>& ghosts,
             const GhostVelocities<dim>& v_ghost, const GhostMasses& m_ghost, const BodyOfGhost& of,
             const GhostNeighbourhood<dim>& near, RigidBodies<dim>& bodies) const {
        for (Index i = 0; i < x.size(); ++i)
            near.template sum<double>(x, i, ghosts, [&](const auto& n) -> double {
                const double strength =
                    m[i] * m_ghost[n.j] * mu / (rho[i] * rho[i]) * -2.0 * w.derivative(n.r) / n.r;
                bodies[of[n.j]].push(strength * (v[i] - v_ghost[n.j]), ghosts[n.j]);
                return 0.0;
            });
    }
};

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
template <int Dim, template <class> class OnBodies> double lost_with_viscosity() {
    constexpr double mu = 30.0;  // as strong as the pressure
    return lost_momentum<Dim>(h, GhostViscosity<W<Dim>>{W<Dim>(h), mu},
                              OnBodies<W<Dim>>{W<Dim>(h), mu});
}
template <class K> using AtParticles = ViscosityOnBodies<K>;
const Register viscous{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "rigid_coupling.viscosity_gives_what_it_takes",
                 .source = {Paper::plumbline, "docstring of ViscosityOnBodies"},
                 .says =
                     "the same with viscosity of ghosts, as strong; wrong: the body takes the "
                     "forces over where its ghosts are, not where the particles are",
                 .bound = at_most(1e-13,
                                  "the same terms in other orders: up to 1000 particles near the "
                                  "body, √1000 · 20 terms · 1.1e-16"),
                 .measure = [] { return lost_with_viscosity<D, AtParticles>(); },
                 .sabotaged = [] { return lost_with_viscosity<D, ViscosityAtGhosts>(); }};
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
}  // namespace
}  // namespace rigid_coupling_claims
