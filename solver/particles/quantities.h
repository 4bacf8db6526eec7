#pragma once

#include "solver/foundation/types.h"

#include <string_view>

namespace plumbline {

/// What a quantity is kept of: the particles that move by their own forces, or the ghosts that stand
/// for a wall, an image or a rigid body (adams2009 Sec. 6.3).
struct Particles {};
struct Ghosts {};

/// One T for each member of a set. Quantities are types of their own, so that no pass can be handed
/// a velocity for a position.
template <class T, class Set = Particles> struct Each : std::vector<T> { using set = Set; };

template <int Dim> struct Positions : Each<Vec<Dim>> {  // [m]
    static constexpr std::string_view name = "positions";
};
template <int Dim> struct Velocities : Each<Vec<Dim>> {  // [m/s]
    static constexpr std::string_view name = "velocities";
};
template <int Dim> struct Accelerations : Each<Vec<Dim>> {  // [m/s²]
    static constexpr std::string_view name = "accelerations";
};
struct Masses : Each<double> {  // [kg]
    static constexpr std::string_view name = "masses";
};
struct Density : Each<double> {  // [kg/m^Dim]
    static constexpr std::string_view name = "density";
};
struct Pressure : Each<double> {  // [Pa], in the plane [N/m]
    static constexpr std::string_view name = "pressure";
};

template <int Dim> struct GhostPositions : Each<Vec<Dim>, Ghosts> {  // [m]
    static constexpr std::string_view name = "ghost positions";
};
template <int Dim> struct GhostVelocities : Each<Vec<Dim>, Ghosts> {  // [m/s]
    static constexpr std::string_view name = "ghost velocities";
};
struct GhostMasses : Each<double, Ghosts> {  // [kg]
    static constexpr std::string_view name = "ghost masses";
};

/// dQ/dt of a quantity that an integrator advances beside positions and velocities.
template <class Q> struct Rate : Each<typename Q::value_type, typename Q::set> {
    static constexpr std::string_view name = "rate";
};

}  // namespace plumbline
