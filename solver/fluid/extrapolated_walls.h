#pragma once

#include "solver/fluid/dynamic_boundary.h"
#include "solver/fluid/swaying_frame.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/kernel.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/packed_lists.h"

namespace plumbline {

/// The fluid near points of walls, found anew whenever it has moved; walls left out.
template <int Dim> class FluidNearWalls {
public:
    void find(const Positions<Dim>& x, const IsWall& wall, std::span<const Vec<Dim>> points,
              double radius) {
        Vec<Dim> low = Vec<Dim>::Constant(HUGE_VAL), high = -low;
        for (const Vec<Dim>& at : points) low = low.cwiseMin(at), high = high.cwiseMax(at);
        low.array() -= radius, high.array() += radius;
        fluid_.clear(), numbers_.clear();
        for (std::size_t i = 0; i < x.size(); ++i)
            if (wall[i] == 0 && (x[i].array() > low.array()).all() &&
                (x[i].array() < high.array()).all())
                fluid_.push_back(x[i]), numbers_.push_back(Index(i));
        grid_.build(fluid_, radius);
        grid_.query(points, rows_);
    }
    /// p = Σⱼ (pⱼ + ρⱼ g·(x − xⱼ)) ωⱼ / Σⱼ ωⱼ at the k-th of the points, x, over the fluid j around: the
    /// mean of what each particle's pressure becomes on the way to the wall, where fluid in contact moves as the wall does, so
    /// that ∇p = ρ g along the normal; g is the apparent gravity of the wall's frame. 0 where there is no fluid.
    /// Exact for fluid at rest in that frame, p linear.        Adami, Hu and Adams 2012, Eq. 27
    template <RadialKernel K>
    double pressure(Index k, const Vec<Dim>& at, const K& w, const Vec<Dim>& g, const Density& rho,
                    const Pressure& p) const {
        double total = 0.0, weights = 0.0;
        for (const Index near : rows_.of(k)) {
            const Vec<Dim> to_wall = at - fluid_[near];
            const Index j = numbers_[near];
            const double weight = w.value(to_wall.norm());
            total += weight * (p[j] + rho[j] * g.dot(to_wall)), weights += weight;
        }
        return weights > 0.0 ? total / weights : 0.0;
    }

private:
    CellGrid<Dim> grid_;
    std::vector<Vec<Dim>> fluid_;
    std::vector<Index> numbers_;
    PackedLists rows_;
};

/// Gives the particles of walls the pressure that the fluid has there, see FluidNearWalls, but no negative one: walls
/// push and do not pull; and the density that goes with it. Layers of them as deep as the support continue the
/// lattice of the fluid. After the pressure of the fluid, before what sums over pairs.
///                                                                     Adami, Hu and Adams 2012
template <RadialKernel K> struct ExtrapolateToWalls {
    static constexpr int dim = K::dim;
    struct Memory {
        FluidNearWalls<dim> near;
        std::vector<Index> walls;
        Points<dim> points;
    };
    using Reads = Quantities<Positions<dim>, IsWall, ApparentGravity<dim>>;
    using Writes = Quantities<Density, Pressure, Memory>;
    K w;
    TaitEquation equation;

    void run(double, const Positions<dim>& x, const IsWall& wall,
             const ApparentGravity<dim>& gravity, Density& rho, Pressure& p, Memory& memory) const {
        memory.walls.clear(), memory.points.clear();
        for (std::size_t i = 0; i < x.size(); ++i)
            if (wall[i] != 0) memory.walls.push_back(Index(i)), memory.points.push_back(x[i]);
        memory.near.find(x, wall, memory.points, w.support());
        parallel_for(memory.walls.size(), [&](std::size_t k) {
            const double pressure = std::max(
                0.0, memory.near.pressure(Index(k), memory.points[k], w, gravity.value, rho, p));
            const Index i = memory.walls[k];
            p[i] = pressure, rho[i] = equation.density(pressure);
        });
    }
};

/// What the fluid does to each particle of a wall [N], in the plane [N/m]; 0 for the fluid.
template <int Dim> struct WallForces : Each<Vec<Dim>> {
    static constexpr std::string_view name = "forces on walls";
};

/// fᵢ = mᵢ (aᵢ − g) of the particles of walls, before HoldWalls forgets it, g being the apparent gravity. Forces of pairs
/// are equal and opposite, so that fluid loses what walls gain, to rounding.
template <int Dim> struct KeepWallForces {
    using Reads = Quantities<IsWall, Masses, Accelerations<Dim>, ApparentGravity<Dim>>;
    using Writes = Quantities<WallForces<Dim>>;

    void run(double, const IsWall& wall, const Masses& m, const Accelerations<Dim>& a,
             const ApparentGravity<Dim>& gravity, WallForces<Dim>& force) const {
        force.resize(wall.size());
        parallel_for_parts(wall.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                force[i] =
                    wall[i] != 0 ? Vec<Dim>(m[i] * (a[i] - gravity.value)) : Vec<Dim>::Zero();
        });
    }
};

}  // namespace plumbline
