#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"
#include "solver/particles/solid.h"

#include <optional>

namespace plumbline {

/// Where fluid comes in: a segment in the plane, a disc in space.
template <int Dim> struct Emitter {
    Vec<Dim> centre;          // [m]
    Vec<Dim> direction;       // of the flow, across the segment or the disc; of length 1
    double radius;            // or half of the length [m]
    double speed;             // [m/s]
    double until = HUGE_VAL;  // [s]
    double spacing;           // [m]
    double mass, density;     // of each particle [kg], [kg/m^Dim]
};
/// What an emitter has done since the start.
struct EmitterState {
    double time = 0.0;       // [s]
    double layers = 0.0;     // how many are out
    double particles = 0.0;  // how many of them
    double mass = 0.0;       // [kg]
    double blocked = 0.0;    // places at which no particle came, as another one was there

    static EmitterState Zero() { return {}; }
};
/// What has left through a region.
struct OutflowState {
    double particles = 0.0, mass = 0.0;  // [kg]

    static OutflowState Zero() { return {}; }
};
struct Emitters {};
struct Outflows {};
struct EmitterStates : Each<EmitterState, Emitters> {
    static constexpr std::string_view name = "emitters";
};
struct OutflowStates : Each<OutflowState, Outflows> {
    static constexpr std::string_view name = "outflows";
};

/// Particles that come and go. A layer of each emitter, a lattice in its segment or disc, comes each time that
/// the flow has moved on by a spacing d, at t = n d/v, and is put where it would be by now: whatever the time step, the
/// jet begins as a lattice, and the mass is ρ A v t, to within a layer, A the area of the lattice. No particle comes
/// closer than d/2 to another one. HoldInflow is what keeps the layers together as long as nothing is behind
/// them. Particles inside of an outflow are gone.
template <int Dim> struct OpenFlow {
    std::vector<Emitter<Dim>> emitters;
    std::vector<Shape<Dim>> outflows;

    /// The particles that stay, in their order, and the account of the others; nothing if all of them stay.
    std::optional<std::vector<Index>> staying(const Positions<Dim>& x, const Masses& m,
                                              OutflowStates& states) const;
    /// Appends all particles that are due.
    void emit(Positions<Dim>& x, Velocities<Dim>& v, Masses& m, Density& rho,
              EmitterStates& states) const;
};

/// The places of a layer, from the centre: a lattice, in the plane with its cells in the segment, in space with its
/// cells' centres in the disc.
template <int Dim> Points<Dim> layer_of(const Emitter<Dim>& emitter);

/// Whether x is in front of the emitter, up to `depth`.
template <int Dim> bool is_in_inlet(const Emitter<Dim>& e, double depth, const Vec<Dim>& x) {
    const Vec<Dim> from = x - e.centre;
    const double ahead = e.direction.dot(from);
    return ahead >= -1e-9 * e.spacing && ahead < depth &&
           (from - ahead * e.direction).norm() < e.radius + 0.5 * e.spacing;
}

/// a = (v_e − v)/Δt in front of an emitter, up to `depth`: fluid that has just come goes on at the speed of the
/// emitter, as if pushed by more of it from behind. The last one of the forces.
template <int Dim> struct HoldInflow {
    using Reads = Quantities<Positions<Dim>, Velocities<Dim>>;
    using Writes = Quantities<Accelerations<Dim>>;
    std::vector<Emitter<Dim>> emitters;
    double depth;  // the support [m]

    void run(double dt, const Positions<Dim>& x, const Velocities<Dim>& v,
             Accelerations<Dim>& a) const {
        for (const Emitter<Dim>& e : emitters)
            for (std::size_t i = 0; i < x.size(); ++i) {
                if (!is_in_inlet(e, depth, x[i])) continue;
                a[i] = dt > 0.0 ? Vec<Dim>((e.speed * e.direction - v[i]) / dt) : Vec<Dim>::Zero();
            }
    }
};
/// The same for velocities that a projection has changed: v = v_e. Before they move particles.
template <int Dim> struct SetInflow {
    using Reads = Quantities<Positions<Dim>>;
    using Writes = Quantities<Velocities<Dim>>;
    std::vector<Emitter<Dim>> emitters;
    double depth;  // the support [m]

    void run(double, const Positions<Dim>& x, Velocities<Dim>& v) const {
        for (const Emitter<Dim>& e : emitters)
            for (std::size_t i = 0; i < x.size(); ++i)
                if (is_in_inlet(e, depth, x[i])) v[i] = e.speed * e.direction;
    }
};

}  // namespace plumbline
