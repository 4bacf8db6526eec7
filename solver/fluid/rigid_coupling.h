#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <Eigen/Geometry>

namespace plumbline {

/// What turns a body: a number in the plane, a vector in space.
template <int Dim> inline constexpr int turns = Dim == 2 ? 1 : 3;
template <int Dim> using Turn = Eigen::Matrix<double, turns<Dim>, 1>;

/// a × b, in the plane its one component.
template <int Dim> Turn<Dim> cross_product(const Vec<Dim>& a, const Vec<Dim>& b) {
    if constexpr (Dim == 2)
        return Turn<2>(a[0] * b[1] - a[1] * b[0]);
    else
        return a.cross(b);
}
/// ω × x.
template <int Dim> Vec<Dim> turned(const Turn<Dim>& omega, const Vec<Dim>& x) {
    if constexpr (Dim == 2)
        return omega[0] * Vec<2>(-x[1], x[0]);
    else
        return omega.cross(x);
}

/// A rigid body that the fluid moves.
template <int Dim> struct RigidBody {
    double mass = 1.0;                                              // [kg]
    Eigen::Matrix<double, turns<Dim>, turns<Dim>> inertia =         // at rest, about the centre
        Eigen::Matrix<double, turns<Dim>, turns<Dim>>::Identity();  // [kg m²]
    Vec<Dim> centre = Vec<Dim>::Zero();                             // of mass [m]
    Mat<Dim> rotation = Mat<Dim>::Identity();                       // from rest
    Vec<Dim> velocity = Vec<Dim>::Zero();                           // [m/s]
    Turn<Dim> spin = Turn<Dim>::Zero();                             // ω [rad/s]
    Vec<Dim> force = Vec<Dim>::Zero();                              // of the fluid [N]
    Turn<Dim> torque = Turn<Dim>::Zero();                           // about the centre [N m]
};
template <int Dim> struct RigidBodies { std::vector<RigidBody<Dim>> all; };

/// To which body a ghost belongs, by number; and where it is in the body at rest, from the centre.
struct BodyOfGhost : Each<Index, Ghosts> {
    static constexpr std::string_view name = "bodies of ghosts";
};
template <int Dim> struct PlaceInBody : Each<Vec<Dim>, Ghosts> {  // [m]
    static constexpr std::string_view name = "places in bodies";
};
/// The number of what does not move: ghosts of walls.
inline constexpr Index no_body = ~Index{0};

/// xₖ = X + R rₖ, vₖ = V + ω × (xₖ − X): ghosts go with their bodies. Before their neighbours are found.
template <int Dim> struct CarryGhosts {
    using Reads = Quantities<RigidBodies<Dim>, BodyOfGhost, PlaceInBody<Dim>>;
    using Writes = Quantities<GhostPositions<Dim>, GhostVelocities<Dim>>;

    void run(double, const RigidBodies<Dim>& bodies, const BodyOfGhost& of,
             const PlaceInBody<Dim>& place, GhostPositions<Dim>& x, GhostVelocities<Dim>& v) const {
        for (std::size_t k = 0; k < x.size(); ++k) {
            if (of[k] == no_body) continue;
            const RigidBody<Dim>& body = bodies.all[of[k]];
            const Vec<Dim> arm = body.rotation * place[k];
            x[k] = body.centre + arm;
            v[k] = body.velocity + turned<Dim>(body.spin, arm);
        }
    }
};

/// F = −Σ Fᵢₖ and T = Σ (xₖ − X) × (−Fᵢₖ) over the ghosts k of a body and the particles i near them, Fᵢₖ the forces that
/// GhostPressureForce gives to particles: what the fluid gets, the body loses. adams2009 Sec. 6.3; Akinci et al. 2012
/// Forces of before are forgotten.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct PressureOnBodies {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Pressure, GhostPositions<dim>,
                             GhostMasses, BodyOfGhost, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<RigidBodies<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho,
             const Pressure& p, const GhostPositions<dim>& ghosts, const GhostMasses& m_ghost,
             const BodyOfGhost& of, const GhostNeighbourhood<dim, Space>& near,
             RigidBodies<dim>& bodies) const {
        for (RigidBody<dim>& body : bodies.all) body.force.setZero(), body.torque.setZero();
        for (Index i = 0; i < x.size();
             ++i) {  // in one order, for sums that do not depend on threads
            if (p[i] <= 0.0) continue;
            near.template sum<double>(x, i, ghosts, [&](const auto& n) -> double {
                if (of[n.j] == no_body) return 0.0;
                RigidBody<dim>& body = bodies.all[of[n.j]];
                const Vec<dim> force =
                    m[i] * m_ghost[n.j] * 2.0 * p[i] / (rho[i] * rho[i]) * gradient(w, n);
                body.force += force;
                body.torque += cross_product<dim>(ghosts[n.j] - body.centre, force);
                return 0.0;
            });
        }
    }
};

/// V += Δt (F/M + g), ω += Δt J⁻¹ (T − ω × J ω), then X and R by the new ones; J = R J₀ Rᵀ. Of order 1, as SymplecticEuler;
/// R stays a rotation, to rounding.
template <int Dim> struct MoveBodies {
    using Reads = Quantities<>;
    using Writes = Quantities<RigidBodies<Dim>>;
    Vec<Dim> gravity;  // [m/s²]

    void run(double dt, RigidBodies<Dim>& bodies) const {
        for (RigidBody<Dim>& body : bodies.all) {
            body.velocity += dt * (body.force / body.mass + gravity);
            body.centre += dt * body.velocity;
            if constexpr (Dim == 2) {
                body.spin += dt / body.inertia(0, 0) * body.torque;
                body.rotation = Eigen::Rotation2Dd(dt * body.spin[0]) * body.rotation;
            } else {
                const Mat<3> J = body.rotation * body.inertia * body.rotation.transpose();
                const Vec<3> gyration = body.spin.cross(J * body.spin);
                body.spin += dt * J.inverse() * (body.torque - gyration);
                const double angle = dt * body.spin.norm();
                if (angle > 0.0)
                    body.rotation =
                        Eigen::AngleAxisd(angle, body.spin.normalized()) * body.rotation;
            }
        }
    }
};

}  // namespace plumbline
