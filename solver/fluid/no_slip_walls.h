#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/fluid/dynamic_boundary.h"
#include "solver/fluid/mirror_ghosts.h"

namespace plumbline {

/// vₖ = v_w − (dₖ/d) (v − v_w) for the particles k of plane walls, dₖ behind their plane, v = Σ vⱼ ωⱼ / Σ ωⱼ and
/// d = Σ dⱼ ωⱼ / Σ ωⱼ over the fluid j near them, dⱼ before the plane: velocities go on linearly through
/// that of the wall, v_w, at its surface.              Morris et al. 1997, with the mean of Adami et al. 2012
/// Exact for a shear flow along the wall, so viscosity is of the order of its own sums; walls with the fixed velocity v_w
/// are of order 1. Before viscosity; RestWalls comes after it, since walls are not moved. A particle behind several planes
/// is of the one that it is the farthest behind.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct StickToWalls {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, IsWall, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Velocities<dim>>;
    K w;
    std::vector<MirrorPlane<dim>> planes;  // n points into the fluid

    void run(double, const Positions<dim>& x, const IsWall& wall,
             const Neighbourhood<dim, Space>& near, Velocities<dim>& v) const {
        const auto before = [&](const MirrorPlane<dim>& plane, std::size_t i) {
            return plane.n.dot(x[i] - plane.point);
        };
        parallel_for(x.size(), [&](std::size_t k) {
            if (wall[k] == 0) return;
            const auto& plane = *std::ranges::min_element(
                planes, {}, [&](const MirrorPlane<dim>& p) { return before(p, k); });
            double weights = 0.0, distances = 0.0;
            const Vec<dim> velocities =
                near.template sum<Vec<dim>>(x, Index(k), [&](const auto& n) -> Vec<dim> {
                    if (wall[n.j] != 0) return Vec<dim>::Zero();
                    const double weight = w.value(n.r);
                    weights += weight, distances += weight * before(plane, n.j);
                    return weight * v[n.j];
                });
            v[k] = plane.velocity;
            if (distances > 0.0)
                v[k] += before(plane, k) / distances * (velocities - weights * plane.velocity);
        });
    }
};

/// v = 0 of the particles of walls.
template <int Dim> struct RestWalls {
    using Reads = Quantities<IsWall>;
    using Writes = Quantities<Velocities<Dim>>;
    void run(double, const IsWall& wall, Velocities<Dim>& v) const {
        for (std::size_t i = 0; i < v.size(); ++i)
            if (wall[i] != 0) v[i].setZero();
    }
};

}  // namespace plumbline
