#include "solver/scene/start.h"

#include "solver/kernels/cubic_spline.h"
#include "solver/particles/hexagonal.h"
#include "solver/particles/jittered.h"
#include "solver/particles/lattice.h"
#include "solver/scene/grid_passes.h"
#include "solver/scene/scene_bodies.h"

#include <algorithm>
#include <sstream>

namespace plumbline {

namespace {
std::string in_words(double x) {
    std::ostringstream text;
    text << x;
    return text.str();
}
template <int Dim> Vec<Dim> flat(const Vec<3>& x) { return x.template head<Dim>(); }

template <int Dim> Points<Dim> sampled(const FluidBlock& block, const Box<Dim>& box, double d) {
    if (block.sampling == FluidSampling::jittered) return jittered<Dim>(box, d, block.jitter, 1);
    if constexpr (Dim == 2)
        if (block.sampling == FluidSampling::hexagonal) return hexagonal(box, d);
    return lattice<Dim>(box, d);
}

/// p of a column at rest whose surface is the top of the block.
template <int Dim>
double hydrostatic_pressure(const SceneFile& scene, const FluidBlock& block, const Vec<Dim>& x) {
    const Vec<Dim> g = flat<Dim>(scene.gravity);
    double highest = -HUGE_VAL;  // of −g·x over the corners of the box
    for (int corner = 0; corner < 1 << Dim; ++corner) {
        Vec<Dim> y;
        for (int d = 0; d < Dim; ++d) y[d] = (corner >> d & 1) != 0 ? block.high[d] : block.low[d];
        highest = std::max(highest, -g.dot(y));
    }
    return scene.density * (highest + g.dot(x));
}

/// The mass of a cell of the lattice over ρ₀: its volume, or for an incompressible fluid what gives a lattice the
/// density ρ₀, since a solver would take any more for compression.
template <int Dim> double mass_of_cell(const SceneFile& scene) {
    const double d = scene.spacing;
    if (scene.method != Method::dfsph) return std::pow(d, Dim);
    const CubicSpline<Dim> w(scene.support);
    const auto reach = Vec<Dim>::Constant((std::ceil(scene.support / d) + 0.5) * d);
    double sum = 0.0;
    for (const Vec<Dim>& x : lattice<Dim>({-reach, reach}, d)) sum += w.value(x.norm());
    return 1.0 / sum;
}

template <int Dim> void add(const SceneFile& scene, const FluidBlock& block, Start<Dim>& start) {
    const double d = scene.spacing;
    const double cell = (block.sampling == FluidSampling::hexagonal ? std::sqrt(0.75) : 1.0) *
                        mass_of_cell<Dim>(scene);
    const TaitEquation tait = tait_of(scene);
    Points<Dim> points;
    try {
        points = sampled<Dim>(block, {flat<Dim>(block.low), flat<Dim>(block.high)}, d);
    } catch (const InvalidInput& e) {
        throw InvalidInput(block.place + ": " + e.what());
    }
    const std::size_t before = start.x.size();
    for (const Vec<Dim>& x : points) {
        const Vec<Dim> from_centre = x - flat<Dim>(block.centre);
        if (block.sphere && !(from_centre.norm() < block.radius)) continue;
        const double rho = block.hydrostatic
                               ? tait.density(hydrostatic_pressure<Dim>(scene, block, x))
                               : scene.density;
        start.x.push_back(x);
        start.v.push_back(flat<Dim>(block.velocity) +
                          block.stretching.template topLeftCorner<Dim, Dim>() * from_centre);
        start.m.push_back(rho * cell);
        start.rho.push_back(rho);
    }
    if (start.x.size() == before)
        throw InvalidInput(block.place +
                           ": expected a block with particles, found none of spacing " +
                           std::to_string(d) + " in it");
}

template <int Dim> void require_apart(const SceneFile& scene, const Start<Dim>& start) {
    Positions<Dim> all;
    all.assign(start.x.begin(), start.x.end());
    all.insert(all.end(), start.ghosts.begin(), start.ghosts.end());
    Neighbourhood<Dim> near;
    FindInGrid<Dim>{0.2 * scene.spacing}.run(0.0, all, near);
    for (Index i = 0; i < start.x.size(); ++i)
        for (const Index j : near.lists.of(i))
            if (j != i)
                throw InvalidInput(
                    scene.name +
                    ": expected blocks that do not overlap, nor reach into walls; found "
                    "particles at " +
                    in_words(all[i][0]) + ", " + in_words(all[i][1]) + " closer than 0.2 spacings");
}

/// How many cells an edge of a tank holds.
double cells_of_edge(const Wall& wall, double length, double d) {
    const double cells = std::round(length / d);
    if (cells < 1.0 || std::abs(length / d - cells) > 1e-6)
        throw InvalidInput(wall.place +
                           ": expected a tank whose edges are multiples of the spacing " +
                           in_words(d) + ", found " + in_words(length));
    return cells;
}

template <int Dim> void add_tank(const SceneFile& scene, const Wall& wall, Start<Dim>& start) {
    const double d = scene.spacing, layers = scene.wall_layers;
    Box<Dim> around{flat<Dim>(wall.low), flat<Dim>(wall.high)};
    std::array<double, Dim> below, cells;
    for (int k = 0; k < Dim; ++k) {
        cells[k] = cells_of_edge(wall, wall.high[k] - wall.low[k], d);
        below[k] = wall.open[k][0] ? 0.0 : layers;
        around.low[k] -= below[k] * d;
        // Half a cell more, so that rounding cannot take the last one.
        around.high[k] =
            around.low[k] + (below[k] + cells[k] + (wall.open[k][1] ? 0.0 : layers) + 0.5) * d;
    }
    const auto is_wall = [&](const std::array<std::int64_t, Dim>& cell) {
        for (int k = 0; k < Dim; ++k) {
            const double at = static_cast<double>(cell[k]) - below[k];
            if (at < 0.0 || at >= cells[k]) return true;
        }
        return false;
    };
    const auto ghosts = cell_centres<Dim>(around, Vec<Dim>::Constant(d), is_wall);
    start.ghosts.insert(start.ghosts.end(), ghosts.begin(), ghosts.end());
}

/// Ghosts in the lattice cells behind the plane, as far as the domain reaches.
template <int Dim> void add_plane(const SceneFile& scene, const Wall& wall, Start<Dim>& start) {
    const double d = scene.spacing, thickness = scene.wall_layers * d;
    if (!scene.domain)
        throw InvalidInput(wall.place +
                           ": expected a table [domain], which bounds the plane, found none");
    const Vec<Dim> point = flat<Dim>(wall.point), normal = flat<Dim>(wall.normal);
    Box<Dim> around{flat<Dim>((*scene.domain)[0]), flat<Dim>((*scene.domain)[1])};
    for (int k = 0; k < Dim; ++k) {
        // Cells begin at the plane where it is across this axis.
        const double cells = std::ceil((point[k] - around.low[k] + thickness) / d - 1e-9);
        around.low[k] = point[k] - cells * d;
        around.high[k] += thickness + 0.5 * d;
    }
    for (const Vec<Dim>& x : lattice<Dim>(around, d)) {
        const double depth = normal.dot(point - x);
        if (depth > 0.0 && depth < thickness) start.ghosts.push_back(x);
    }
}

template <int Dim> void add_body(const SceneFile& scene, const SceneBody& body, Start<Dim>& start) {
    const RigidBody<Dim> at_start = body_at_start<Dim>(body).body;
    for (const Vec<Dim>& x : ghosts_of<Dim>(body, scene.spacing, scene.wall_layers)) {
        start.ghosts.push_back(x);
        start.ghost_velocities.push_back(at_start.velocity_at(x));
        start.body_of_ghost.push_back(static_cast<Index>(start.bodies.size()));
        start.places.push_back(x - at_start.centre);
    }
    start.bodies.push_back(at_start);
}

/// Where a body is, there is no fluid.
template <int Dim> void make_room(const SceneFile& scene, Start<Dim>& start) {
    GhostPositions<Dim> of_bodies;
    for (std::size_t k = 0; k < start.ghosts.size(); ++k)
        if (start.body_of_ghost[k] != no_body) of_bodies.push_back(start.ghosts[k]);
    GhostNeighbourhood<Dim> near;
    FindGhostsInGrid<Dim>{0.7 * scene.spacing}.run(0.0, start.x, of_bodies, near);
    std::vector<Shape<Dim>> shapes;
    for (const SceneBody& body : scene.bodies) shapes.push_back(shape_of<Dim>(body.shape));
    std::size_t kept = 0;
    for (Index i = 0; i < start.x.size(); ++i) {
        const bool is_in = std::ranges::any_of(shapes, [&](const Shape<Dim>& shape) {
            return from_surface<Dim>(shape, start.x[i]).distance < 0.0;
        });
        if (is_in || !near.lists.of(i).empty()) continue;
        start.x[kept] = start.x[i], start.v[kept] = start.v[i];
        start.m[kept] = start.m[i], start.rho[kept] = start.rho[i];
        ++kept;
    }
    start.x.resize(kept), start.v.resize(kept), start.m.resize(kept), start.rho.resize(kept);
}
}  // namespace

template <int Dim> Start<Dim> start_of(const SceneFile& scene) {
    Start<Dim> start;
    for (const FluidBlock& block : scene.blocks) add<Dim>(scene, block, start);
    for (const Wall& wall : scene.walls) {
        if (wall.plane)
            add_plane<Dim>(scene, wall, start);
        else
            add_tank<Dim>(scene, wall, start);
        start.ghost_velocities.resize(start.ghosts.size(), flat<Dim>(wall.velocity));
    }
    start.body_of_ghost.assign(start.ghosts.size(), no_body);
    start.places.assign(start.ghosts.size(), Vec<Dim>::Zero());
    for (const SceneBody& body : scene.bodies) add_body<Dim>(scene, body, start);
    if (!scene.bodies.empty()) make_room<Dim>(scene, start);
    start.ghost_masses.assign(start.ghosts.size(), scene.density * mass_of_cell<Dim>(scene));
    require_apart<Dim>(scene, start);
    return start;
}

template <int Dim> Shape<Dim> shape_of(const SolidShape& solid) {
    using enum SolidShape::Form;
    if (solid.form == plane) return HalfSpace<Dim>{flat<Dim>(solid.point), flat<Dim>(solid.normal)};
    if (solid.form == sphere) return Ball<Dim>{flat<Dim>(solid.centre), solid.radius};
    if constexpr (Dim == 3)
        if (solid.form == mesh) {
            if (!solid.mesh)
                throw InvalidInput(solid.mesh_file.string() +
                                   ": expected a mesh that was read, found its name only");
            return MeshSolid{solid.mesh};
        }
    return Cuboid<Dim>{flat<Dim>(solid.low), flat<Dim>(solid.high)};
}

template <int Dim> std::vector<Constraint<Dim>> solids_of(const SceneFile& scene) {
    std::vector<Constraint<Dim>> all;
    const auto add = [&](const Vec<3>& point, const Vec<3>& n) {
        all.push_back({.shape = HalfSpace<Dim>{flat<Dim>(point), flat<Dim>(n)}});
    };
    for (const Wall& wall : scene.walls) {
        if (wall.plane) add(wall.point, wall.normal);
        for (int d = 0; d < Dim && !wall.plane; ++d) {
            if (!wall.open[d][0]) add(wall.low, Vec<3>::Unit(d));
            if (!wall.open[d][1]) add(wall.high, -Vec<3>::Unit(d));
        }
    }
    for (const SolidConstraint& c : scene.constraints)
        all.push_back(
            {shape_of<Dim>(c.shape), c.hollow, c.restitution, c.friction, flat<Dim>(c.velocity)});
    return all;
}

template <int Dim> double mass_of_particle(const SceneFile& scene) {
    return scene.density * mass_of_cell<Dim>(scene);
}

template double mass_of_particle<2>(const SceneFile&);
template double mass_of_particle<3>(const SceneFile&);
template std::vector<Constraint<2>> solids_of<2>(const SceneFile&);
template std::vector<Constraint<3>> solids_of<3>(const SceneFile&);
template Shape<2> shape_of<2>(const SolidShape&);
template Shape<3> shape_of<3>(const SolidShape&);
template Start<2> start_of<2>(const SceneFile&);
template Start<3> start_of<3>(const SceneFile&);

}  // namespace plumbline
