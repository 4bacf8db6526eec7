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
        for (int d = 0; d < Dim; ++d) {
            // A cell is no wider than distance/√Dim across: it holds one point at most.
            const double along = std::ceil(box.size()[d] / distance * std::sqrt(1.0 * Dim));
            edge_[d] = box.size()[d] / along;
            reach_[d] = static_cast<std::int64_t>(std::ceil(distance / edge_[d]));
            stride_[d] = static_cast<std::int64_t>(cells);
            cells *= along + 2.0 * static_cast<double>(reach_[d]);
            require_count(cells);
            n_[d] = static_cast<std::int64_t>(along);
        }
        offsets_in_reach_ = offsets_in_reach();
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
        std::int64_t count = 1;
        for (const std::int64_t n : n_) count *= n;
        std::vector<Cell> cells(static_cast<std::size_t>(count));
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

    /// Where the grid's cell around `cell` is stored. Cells in reach of it always are: there are empty
    /// ones around the box, so that nobody has to ask whether a cell is inside.
    std::size_t grid_index(const Cell& cell, int level) const {
        std::int64_t index = 0;
        for (int d = 0; d < Dim; ++d) index += ((cell[d] >> level) + reach_[d]) * stride_[d];
        return static_cast<std::size_t>(index);
    }

    /// How far from a cell those are stored that can hold a point nearer than the distance to one in
    /// it; the nearest first.
    std::vector<std::ptrdiff_t> offsets_in_reach() const {
        Cell offset;
        for (int d = 0; d < Dim; ++d) offset[d] = -reach_[d];
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
            for (d = 0; d < Dim && ++offset[d] > reach_[d]; ++d) offset[d] = -reach_[d];
        }
        std::ranges::stable_sort(cells, {}, [&](const Cell& c) { return squared_gap(c, 0); });
        std::vector<std::ptrdiff_t> offsets;
        for (const Cell& c : cells) {
            offsets.push_back(0);
            for (int axis = 0; axis < Dim; ++axis) offsets.back() += c[axis] * stride_[axis];
        }
        return offsets;
    }

    /// Calls visit(point) for the points around a cell, until it returns true; then so does this.
    template <class Visit> bool any_near(const Cell& cell, int level, Visit visit) const {
        const Index* const home = &point_of_cell_[grid_index(cell, level)];
        for (const std::ptrdiff_t offset : offsets_in_reach_) {
            const Index i = home[offset];
            if (i != none && visit(points_[i])) return true;
        }
        return false;
    }

    Points<Dim> points_near(const Cell& cell, int level) const {
        Points<Dim> near;
        any_near(cell, level, [&](const Vec<Dim>& p) {
            near.push_back(p);
            return false;
        });
        return near;
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
        Points<Dim> near;
        std::size_t home_of_near = point_of_cell_.size();
        const Vec<Dim> half = edge_ * std::ldexp(1.0, -level - 2);
        for (const Cell& cell : open) {
            const std::size_t home = grid_index(cell, level);
            if (point_of_cell_[home] != none) continue;
            if (home != home_of_near) near = points_near(cell, level);  // parts of one lie together
            home_of_near = home;
            for (int corner = 0; corner < 1 << Dim; ++corner) {
                Cell part;
                for (int d = 0; d < Dim; ++d) part[d] = 2 * cell[d] + (corner >> d & 1);
                const Vec<Dim> middle = low_corner(part, level + 1) + half;
                const bool covered = std::ranges::any_of(near, [&](const Vec<Dim>& p) {
                    const Vec<Dim> farthest = (p - middle).cwiseAbs() + half;
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
    Cell n_{};  // cells along each axis, ...
    Cell
        reach_{};  // the empty ones on either side of them, and how far apart neighbours are stored
    Cell stride_{};
    Vec<Dim> edge_;
    std::vector<std::ptrdiff_t> offsets_in_reach_;
    std::vector<Index> point_of_cell_;
    Points<Dim> points_;
};

/// The points of PoissonDisc(box, distance, seed).
template <int Dim>
Points<Dim> poisson_disc(const Box<Dim>& box, double distance, std::uint64_t seed) {
    return PoissonDisc<Dim>(box, distance, seed).fill();
}

}  // namespace plumbline
