#pragma once

#include "solver/foundation/types.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

class ClosedMesh;

/// Which composition of passes advances the fluid.
enum class Method {
    sph,        // adams2009 Algorithm 5: densities are sums (Eq. 5); symplectic Euler
    delta_sph,  // densities follow continuity, smoothed by diffusion; two stages per step
    dfsph       // incompressible: pressures are solved for, Bender and Koschier 2017
};
enum class PressureForm { symmetric, averaged, plain };  // adams2009 Eqs. 51, below 50, 50
enum class ViscosityForm { none, artificial, brookshaw, monaghan };
enum class XsphForm { velocities, motion };
enum class FluidSampling { lattice, hexagonal, jittered };

// Vectors have three components in every scene; in the plane the last one is 0.

/// Fluid at the start: what of a sampling is in a box or a sphere (a circle).
struct FluidBlock {
    bool sphere = false;
    Vec<3> low, high;     // of the box, and around the sphere [m]
    Vec<3> centre;        // [m]
    double radius = 0.0;  // [m]
    Vec<3> velocity;      // [m/s]
    Mat<3> stretching;    // velocity += stretching (x − centre) [1/s]
    FluidSampling sampling = FluidSampling::lattice;
    double jitter = 0.0;       // of the spacing
    bool hydrostatic = false;  // pressure of a column at rest, 0 at the top of the box
    std::string place;         // "file:line:column", for messages
};

/// Ghosts that stand for a wall (adams2009 Sec. 6.3): around a box, or behind a plane.
struct Wall {
    bool plane = false;
    Vec<3> low, high;                              // of the box inside [m]
    std::array<std::array<bool, 2>, 3> open = {};  // sides without wall: axis, low and high side
    Vec<3> point, normal;                          // of the plane; the normal points to the fluid
    Vec<3> velocity;                               // along the wall [m/s]
    std::string place;
};

/// A solid, where it is at the start.
struct SolidShape {
    enum class Form { plane, box, sphere, mesh } form = Form::box;
    Vec<3> point, normal;  // of the plane; the normal points out of the solid
    Vec<3> low, high;      // of the box [m]
    Vec<3> centre;         // [m]
    double radius = 0.0;   // [m]
    std::filesystem::path
        mesh_file;  // of a closed surface of triangles; as seen from the scene file
    std::shared_ptr<const ClosedMesh> mesh;  // what is in that file: read_meshes fills it in
};

/// What particles may not enter, though it has no ghosts; see EnforceConstraints.
struct SolidConstraint {
    SolidShape shape;
    bool hollow = false;  // particles stay in the shape, not out of it
    double restitution = 0.0, friction = 0.0;
    Vec<3> velocity;  // of the surface [m/s]
    std::string place;
};

/// A rigid body, which ghosts make up; see RigidBody.
struct SceneBody {
    std::string name;
    SolidShape shape;      // no plane
    bool fixed = false;    // it keeps its velocity and its spin; otherwise it has
    double mass = 0.0;     // [kg], or where this is 0,
    double density = 0.0;  // [kg/m^dim]
    Vec<3> velocity;       // [m/s]
    Vec<3> spin;           // [rad/s]; in the plane its z
    std::string place;
};

/// Where fluid comes in; see Emitter.
struct SceneEmitter {
    Vec<3> centre;                // [m]
    Vec<3> direction;             // of length 1
    double radius = 0.0;          // of the disc, in the plane half of the segment [m]
    double speed = 0.0;           // [m/s]
    std::optional<double> until;  // [s]
    std::string place;
};

struct SurfaceOutput {
    enum class Field { density, blobby, weighted_average } field = Field::density;
    double cell = 0.5;      // of the grid [spacings]
    double level = 0.5;     // of the rest density; of one particle's blob
    double radius = 3.0;    // R of the blobs [spacings]
    double distance = 0.5;  // r of the weighted average [spacings]
    std::string format = "vtp";
};

/// Where something is recorded over time.
struct Probe {
    enum class Quantity { pressure, density, speed, height } quantity = Quantity::pressure;
    std::string name;
    Vec<3> at;  // [m]; of a height only what is across gravity counts
};

/// A simulation as a scene file describes it. Lengths in spacings are turned into metres here.
///
/// Tables of solids and of what moves in and out; `shape` is "box" (low, high), "sphere" (centre, radius),
/// "plane" (point, normal) or, in space, "mesh" (file, beside the scene file: OBJ, OFF, PLY or STL):
/// - [[constraint]] shape, stay = "outside" | "inside", restitution = 0, friction = 0, velocity = 0: particles may
///   not enter it, or leave it; there are no ghosts in it.
/// - [[body]] shape (no plane), name = "body_N", density or mass, velocity = 0, spin = 0 (in space a vector), or
///   fixed = true for one that keeps its velocity and its spin: a rigid body of ghosts.
/// - [contact] restitution = 0, friction = 0: of bodies with each other, with walls and with constraints.
/// - [[emitter]] centre, direction, radius, speed, until: fluid that comes in; [domain] must be there.
/// - [[outflow]] shape: particles in it are taken out.
struct SceneFile {
    std::string name, title, text;  // text: the file itself
    int dim = 2;
    Method method = Method::delta_sph;
    Vec<3> gravity = Vec<3>::Zero();  // [m/s²]

    double spacing = 0.0;  // [m]
    double support = 0.0;  // [m]

    double density = 1000.0;      // ρ₀ [kg/m^dim]
    double speed_of_sound = 0.0;  // c₀ [m/s]
    double exponent = 7.0;        // γ
    double tension = 1.0;         // ζ of Eq. 54
    double diffusion = 0.1;       // δ of the density
    PressureForm pressure_force = PressureForm::symmetric;
    ViscosityForm viscosity = ViscosityForm::none;
    double alpha = 0.0;     // of the artificial viscosity
    double mu = 0.0;        // dynamic viscosity [Pa s]
    double cohesion = 0.0;  // γ of Cohesion [m^(dim + 1)/(kg s²)]
    XsphForm xsph_form = XsphForm::velocities;
    double xsph = 0.0;       // ξ per reference step
    double xsph_step = 0.0;  // the reference step [s]

    std::vector<FluidBlock> blocks;
    std::vector<Wall> walls;
    std::vector<SolidConstraint> constraints;
    std::vector<SceneEmitter> emitters;
    std::vector<SolidShape> outflows;  // where particles are taken out
    std::vector<SceneBody> bodies;
    double body_restitution = 0.0, body_friction = 0.0;  // of their contacts
    int wall_layers = 3;                                 // of bodies, too
    bool no_slip = false;
    std::optional<std::array<Vec<3>, 2>> domain;  // what particles may not leave: low, high

    double end = 0.0;            // [s]
    std::optional<double> step;  // [s]; empty: as long as the limits allow
    std::optional<double> largest_step;

    double interval = 0.0;          // between frames [s]
    double scalar_interval = 0.0;   // between rows of scalars [s]
    std::string picture = "speed";  // what colours the particles; "none": no pictures
    std::optional<SurfaceOutput> surface;
    std::vector<Probe> probes;

    /// Throws InvalidInput "file:line:column: expected …, found …" for what is not TOML, for keys that are
    /// missing, unknown or of another type, and for values that no simulation can have. Files of meshes are
    /// not opened here: see read_meshes.
    static SceneFile read(const std::filesystem::path& path);
    static SceneFile parse(const std::string& name, const std::string& text);
};

}  // namespace plumbline
