#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace plumbline {

/// What turns a body: a number in the plane, a vector in space.
template <int Dim> inline constexpr int turns = Dim == 2 ? 1 : 3;
template <int Dim> using Turn = Eigen::Matrix<double, turns<Dim>, 1>;
template <int Dim> using Inertia = Eigen::Matrix<double, turns<Dim>, turns<Dim>>;

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

/// A rigid body. With an infinite mass nothing acts on it, and it keeps the velocity and the spin that it has.
/// Without padding, so that the bytes of a checkpoint are all known.
template <int Dim> struct RigidBody {
    using Rotation = Eigen::Matrix<double, Dim, Dim, Eigen::DontAlign>;

    Vec<Dim> centre = Vec<Dim>::Zero();               // of mass [m]
    Rotation rotation = Rotation::Identity();         // R, from rest
    Vec<Dim> velocity = Vec<Dim>::Zero();             // [m/s]
    Vec<Dim> force = Vec<Dim>::Zero();                // of the fluid [N]
    double mass = 1.0;                                // [kg]
    Inertia<Dim> inertia = Inertia<Dim>::Identity();  // J₀, at rest, about the centre [kg m²]
    Turn<Dim> spin = Turn<Dim>::Zero();               // ω [rad/s]
    Turn<Dim> torque = Turn<Dim>::Zero();             // of the fluid, about the centre [N m]

    static RigidBody Zero() { return {}; }  // at rest at the origin
    bool is_free() const { return mass < HUGE_VAL; }
    Inertia<Dim> inertia_now() const {  // J = R J₀ Rᵀ
        if constexpr (Dim == 2)
            return inertia;
        else
            return rotation * inertia * rotation.transpose();
    }
    double inverse_mass() const { return is_free() ? 1.0 / mass : 0.0; }
    Inertia<Dim> inverse_inertia() const {
        if (!is_free()) return Inertia<Dim>::Zero();
        return inertia_now().inverse();
    }
    Vec<Dim> velocity_at(const Vec<Dim>& x) const {
        return velocity + turned<Dim>(spin, Vec<Dim>(x - centre));
    }
    /// Adds a force that acts at x.
    void push(const Vec<Dim>& by, const Vec<Dim>& x) {
        force += by;
        torque += cross_product<Dim>(x - centre, by);
    }
};
static_assert(sizeof(RigidBody<2>) == 14 * sizeof(double));
static_assert(sizeof(RigidBody<3>) == 34 * sizeof(double));

struct Bodies {};
template <int Dim> struct RigidBodies : Each<RigidBody<Dim>, Bodies> {
    static constexpr std::string_view name = "bodies";
};

/// V += Δt (F/M + g), ω += Δt J⁻¹ (T − ω × J ω), of free bodies. Before DriftBodies; contacts come in between.
template <int Dim> struct KickBodies {
    using Reads = Quantities<>;
    using Writes = Quantities<RigidBodies<Dim>>;
    Vec<Dim> gravity;  // [m/s²]

    void run(double dt, RigidBodies<Dim>& bodies) const {
        for (RigidBody<Dim>& body : bodies) {
            if (!body.is_free()) continue;
            body.velocity += dt * (body.force / body.mass + gravity);
            Turn<Dim> torque = body.torque;
            if constexpr (Dim == 3) torque -= body.spin.cross(body.inertia_now() * body.spin);
            body.spin += dt * body.inverse_inertia() * torque;
        }
    }
};

/// X += Δt V, and R turns by Δt ω. With KickBodies of order 1, as SymplecticEuler; R stays a rotation, to
/// rounding.
template <int Dim> struct DriftBodies {
    using Reads = Quantities<>;
    using Writes = Quantities<RigidBodies<Dim>>;

    void run(double dt, RigidBodies<Dim>& bodies) const {
        for (RigidBody<Dim>& body : bodies) {
            body.centre += dt * body.velocity;
            if constexpr (Dim == 2) {
                body.rotation = Eigen::Rotation2Dd(dt * body.spin[0]) * Mat<2>(body.rotation);
            } else {
                const double angle = dt * body.spin.norm();
                if (angle > 0.0)
                    body.rotation =
                        Eigen::AngleAxisd(angle, body.spin.normalized()) * Mat<3>(body.rotation);
            }
        }
    }
};

}  // namespace plumbline
