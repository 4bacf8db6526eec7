#pragma once

#include "solver/foundation/errors.h"
#include "solver/scene/open_flow.h"
#include "solver/scene/scene_file.h"
#include "solver/scene/time_step.h"

#include <memory>
#include <span>
#include <string>

namespace plumbline {

/// A rigid body of any scene; in the plane vectors have z = 0, and what turns has only z.
struct BodyState {
    Vec<3> centre;    // of mass [m]
    Vec<3> turn;      // since it was at rest: axis times angle [rad]
    Vec<3> velocity;  // [m/s]
    Vec<3> spin;      // [rad/s]
    Vec<3> force;     // of the fluid [N]
    Vec<3> torque;    // of the fluid, about the centre [N m]
    double mass;      // [kg]; infinite if it is fixed
};

/// The particles of a simulation as arrays of numbers; valid until its next step.
struct Snapshot {
    int dim;
    std::span<const double> x, v;          // dim numbers for each particle [m], [m/s]
    std::span<const double> m, rho, p;     // one for each [kg], [kg/m^dim], [Pa]
    std::span<const double> ghosts;        // positions of the particles of walls and bodies [m]
    std::span<const double> ghost_v = {};  // their velocities [m/s]
    std::span<const Index> body_of_ghost =
        {};  // for each ghost, from 0; of walls it is no body. Empty: all are
    std::vector<BodyState> bodies = {};
    EmitterState emitted = {};  // by all emitters together
    OutflowState removed = {};  // through all outflows together

    std::size_t size() const { return m.size(); }
    double coordinate(std::size_t i, int axis) const {
        return x[i * static_cast<std::size_t>(dim) + static_cast<std::size_t>(axis)];
    }
};

/// What a step with a watch on every term has found, see Watch.
struct Diagnosis {
    std::string fault_term, fault_quantity;  // empty: every number was finite
    std::size_t fault_particle = 0;
    std::string strongest_term;  // that accelerated the particle most
    double strongest = 0.0;      // [m/s²]
};

/// A scene whose composition was chosen at run time, behind one virtual call per step.
class Simulation {
public:
    virtual ~Simulation() = default;
    virtual void step(double dt) = 0;
    virtual TimeStepLimits limits() const = 0;
    virtual Snapshot snapshot() const = 0;
    /// See save_state and load_state.
    virtual void save(std::string& bytes) const = 0;
    virtual void load(std::string_view bytes) = 0;
    /// A step like any other, watched; it may throw what a step throws.
    virtual Diagnosis step_watched(double dt, std::size_t particle) = 0;
};

/// The simulation at its start, with densities, pressures and step limits evaluated.
/// Throws InvalidInput, naming the place in the file, for blocks without particles, for particles that
/// nearly coincide, and for walls whose edges are no multiples of the spacing.
std::unique_ptr<Simulation> make_simulation(const SceneFile& scene);

}  // namespace plumbline
