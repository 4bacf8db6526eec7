#pragma once

#include "solver/foundation/random.h"
#include "solver/particles/box.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace plumbline {

/// Random points, none closer to another than `distance` [m], as many as fit: no further one could
/// be added (Ebeida et al. 2012, "A simple algorithm for maximal Poisson-disk sampling"; Bridson's
/// faster one, 2007, leaves gaps). Every place of the box is less than `distance` from a point.
/// The number is that of random sequential addition: about 0.748, 0.697, 0.73 times
/// volume / distance^Dim in 1, 2, 3 dimensions. The same points for the same seed.
template <int Dim> class PoissonDisc {
public:
    /// Throws InvalidInput for a box without extent, distance ≤ 0, or too many cells for an Index.
    PoissonDisc(const Box<Dim>& box, double distance, std::uint64_t seed)
        : box_{box}, squared_distance_{distance * distance}, random_{seed} {
        require_proper(box);
        require_positive(distance, "distance");
        double cells = 1.0;
        Cell reach;
        for (int d = 0; d < Dim; ++d) {
            // A cell is no wider than distance/√Dim across: it holds one point at most.
            const double along = std::ceil(box.size()[d] / distance * std::sqrt(1.0 * Dim));
            cells *= along;
            require_count(cells);
            n_[d] = static_cast<std::int64_t>(along);
            edge_[d] = box.size()[d] / along;
            reach[d] = static_cast<std::int64_t>(std::ceil(distance / edge_[d]));
        }
        cells_in_reach_ = cells_in_reach(reach);
        point_of_cell_.assign(static_cast<std::size_t>(cells), none);
    }

    Points<Dim> fill() {
        std::vector<Cell> open = whole_cells_of_the_box();
        for (int level = 0; !open.empty() && level < deepest; ++level) {
            throw_darts(open, level);
            open = still_open_parts(open, level);
        }
        return std::move(points_);
    }

private:
    /// A cell of the grid halved `level` times; a place that a point may still take.
    using Cell = std::array<std::int64_t, Dim>;
    static constexpr Index none = static_cast<Index>(-1);
    // Darts per open cell and level: fewer leave more parts, more are thrown in vain.
    static constexpr std::size_t darts_per_cell = 2;
    // Beyond it a part is smaller than the rounding of its coordinates.
    static constexpr int deepest = 48;

    std::vector<Cell> whole_cells_of_the_box() const {
        std::vector<Cell> cells(point_of_cell_.size());
        Cell k{};
        for (Cell& cell : cells) {
            cell = k;
            for (int d = 0; d < Dim && ++k[d] == n_[d]; ++d) k[d] = 0;
        }
        return cells;
    }

    Vec<Dim> low_corner(const Cell& cell, int level) const {
        Vec<Dim> x;
        for (int d = 0; d < Dim; ++d)
            x[d] = box_.low[d] + std::ldexp(static_cast<double>(cell[d]), -level) * edge_[d];
        return x;
    }

    std::size_t grid_index(const Cell& cell, int level) const {
        std::size_t index = 0;
        for (int d = Dim - 1; d >= 0; --d)
            index = index * static_cast<std::size_t>(n_[d]) +
                    static_cast<std::size_t>(cell[d] >> level);
        return index;
    }

    /// Which cells, relative to one, can hold a point nearer than the distance; the nearest first.
    std::vector<Cell> cells_in_reach(const Cell& reach) const {
        Cell offset;
        for (int d = 0; d < Dim; ++d) offset[d] = -reach[d];
        std::vector<Cell> cells;
        const auto squared_gap = [&](const Cell& cell, std::int64_t adjacent) {
            double sum = 0.0;
            for (int d = 0; d < Dim; ++d) {
                const auto between = std::max<std::int64_t>(std::abs(cell[d]) - adjacent, 0);
                sum += std::pow(static_cast<double>(between) * edge_[d], 2);
            }
            return sum;
        };
        for (int d = 0; d < Dim;) {
            if (squared_gap(offset, 1) <= squared_distance_) cells.push_back(offset);
            for (d = 0; d < Dim && ++offset[d] > reach[d]; ++d) offset[d] = -reach[d];
        }
        std::ranges::stable_sort(cells, {}, [&](const Cell& c) { return squared_gap(c, 0); });
        return cells;
    }

    /// Calls visit(point) for the points around a cell, until it returns true; then so does this.
    template <class Visit> bool any_near(const Cell& cell, int level, Visit visit) const {
        for (const Cell& offset : cells_in_reach_) {
            Cell other;
            bool inside = true;
            for (int d = 0; d < Dim; ++d) {
                other[d] = (cell[d] >> level) + offset[d];
                inside = inside && other[d] >= 0 && other[d] < n_[d];
            }
            if (!inside) continue;
            const Index i = point_of_cell_[grid_index(other, 0)];
            if (i != none && visit(points_[i])) return true;
        }
        return false;
    }

    void throw_darts(std::vector<Cell>& open, int level) {
        const double shrink = std::ldexp(1.0, -level);
        for (std::size_t darts = darts_per_cell * open.size(); darts > 0 && !open.empty();
             --darts) {
            const auto pick =
                static_cast<std::size_t>(random_.uniform() * static_cast<double>(open.size()));
            const Cell cell = open[pick];
            Vec<Dim> x = low_corner(cell, level);
            for (int d = 0; d < Dim; ++d) x[d] += random_.uniform() * shrink * edge_[d];
            const bool taken = point_of_cell_[grid_index(cell, level)] != none;
            if (!taken) {
                const bool blocked = any_near(cell, level, [&](const Vec<Dim>& p) {
                    return (p - x).squaredNorm() < squared_distance_;
                });
                if (blocked || !box_.contains(x)) continue;
                point_of_cell_[grid_index(cell, level)] = static_cast<Index>(points_.size());
                points_.push_back(x);
            }
            open[pick] = open.back();
            open.pop_back();
        }
    }

    /// The halves of the open cells that no disc covers alone.
    std::vector<Cell> still_open_parts(const std::vector<Cell>& open, int level) const {
        std::vector<Cell> parts;
        const Vec<Dim> edge = edge_ * std::ldexp(1.0, -level - 1);
        for (const Cell& cell : open) {
            if (point_of_cell_[grid_index(cell, level)] != none) continue;
            for (int corner = 0; corner < 1 << Dim; ++corner) {
                Cell part;
                for (int d = 0; d < Dim; ++d) part[d] = 2 * cell[d] + (corner >> d & 1);
                const Vec<Dim> middle = low_corner(part, level + 1) + 0.5 * edge;
                const bool covered = any_near(part, level + 1, [&](const Vec<Dim>& p) {
                    const Vec<Dim> farthest = (p - middle).cwiseAbs() + 0.5 * edge;
                    return farthest.squaredNorm() < squared_distance_;
                });
                if (!covered) parts.push_back(part);
            }
        }
        return parts;
    }

    Box<Dim> box_;
    double squared_distance_;
    Random random_;
    Cell n_{};  // cells along each axis
    Vec<Dim> edge_;
    std::vector<Cell> cells_in_reach_;
    std::vector<Index> point_of_cell_;
    Points<Dim> points_;
};

/// The points of PoissonDisc(box, distance, seed).
template <int Dim>
Points<Dim> poisson_disc(const Box<Dim>& box, double distance, std::uint64_t seed) {
    return PoissonDisc<Dim>(box, distance, seed).fill();
}

}  // namespace plumbline
