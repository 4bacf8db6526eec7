#pragma once

#include "solver/foundation/random.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"

namespace verification {
namespace pl = plumbline;

/// A cubic lattice of spacing 1 and density 1 with random velocities. Its lower half can be taken for
/// fluid, as all the rest, or for the ghosts of a wall: what a particle near the wall feels is the same.
template <int Dim> struct WallInALattice {
    static constexpr double support = 2.6;
    using W = pl::WendlandC2<Dim>;
    using Particles =
        pl::Given<pl::Positions<Dim>, pl::Velocities<Dim>, pl::Masses, pl::Density, pl::Pressure>;
    using GhostsOfWall =
        pl::Given<pl::GhostPositions<Dim>, pl::GhostVelocities<Dim>, pl::GhostMasses>;

    static W kernel() { return W(support); }

    /// The scene after one evaluation of `passes`; the upper half comes first among the particles.
    template <class... Passes> static auto evaluate(bool with_wall, Passes... passes) {
        pl::Scene scene{Particles{}, GhostsOfWall{},
                        pl::FindNeighbours<Dim, pl::CellGrid<Dim>>{support},
                        pl::FindGhosts<Dim, pl::CellGrid<Dim>>{support}, passes...};
        const auto around = pl::Vec<Dim>::Constant(4.0);
        const auto points = pl::lattice<Dim>({-around, around}, 1.0);
        pl::Random random(1);
        pl::Points<Dim> velocities;
        for (std::size_t i = 0; i < points.size(); ++i)
            velocities.push_back(
                pl::Vec<Dim>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); }));
        for (const bool upper : {true, false})
            for (std::size_t i = 0; i < points.size(); ++i) {
                if ((points[i][Dim - 1] > 0.0) != upper) continue;
                if (upper || !with_wall) {
                    scene.template get<pl::Positions<Dim>>().push_back(points[i]);
                    scene.template get<pl::Velocities<Dim>>().push_back(velocities[i]);
                } else {
                    scene.template get<pl::GhostPositions<Dim>>().push_back(points[i]);
                    scene.template get<pl::GhostVelocities<Dim>>().push_back(velocities[i]);
                }
            }
        const std::size_t n = scene.template get<pl::Positions<Dim>>().size();
        scene.template get<pl::Masses>().assign(n, 1.0);
        scene.template get<pl::Density>().assign(n, 1.0);
        scene.template get<pl::Pressure>().assign(n, 1.0);
        scene.template get<pl::GhostMasses>().assign(
            scene.template get<pl::GhostPositions<Dim>>().size(), 1.0);
        scene.step(0.0);
        return scene;
    }

    /// max |q − q′| / max |q| of the quantity Q in the upper half.
    template <class Q, class One, class Other>
    static double difference(const One& one, const Other& other) {
        const auto& q = one.template get<Q>();
        const auto& r = other.template get<Q>();
        double worst = 0.0, size = 0.0;
        for (std::size_t i = 0; i < std::min(q.size(), r.size()); ++i) {
            worst = std::max(worst, norm(q[i] - r[i]));
            size = std::max(size, norm(q[i]));
        }
        return worst / size;
    }

    /// The difference in Q between a lattice that is fluid throughout, under the pass `inside`, and one with a
    /// wall, where `of_ghosts` is added, or is forgotten.
    template <class Q, class Inside, class OfGhosts>
    static double difference_at_wall(bool with_ghosts, Inside inside, OfGhosts of_ghosts) {
        const auto everything = evaluate(false, inside);
        if (!with_ghosts) return difference<Q>(everything, evaluate(true, inside));
        return difference<Q>(everything, evaluate(true, inside, of_ghosts));
    }

private:
    static double norm(double x) { return std::abs(x); }
    static double norm(const pl::Vec<Dim>& x) { return x.norm(); }
};

inline constexpr double rounding_of_walls = 1e-13;
inline constexpr const char* same_pairs =
    "the same terms, less than 100, in another order: 100 · 1.1e-16 of Σ |terms|, which is below "
    "10 "
    "times the sum";

}  // namespace verification
