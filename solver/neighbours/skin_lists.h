#pragma once

#include "solver/neighbours/cell_grid.h"

namespace plumbline {

/// Neighbour lists of moving points that last for many small steps: they are built with a radius wider by
/// a skin, and again only when some point has moved by half the skin.                     Verlet 1967
///
/// Guarantee: after update(points), for every i row i of lists() has every j with ‖xᵢ − xⱼ‖ < radius, and
/// exact() has no other. Two points come closer by at most twice what each has moved, hence the half.
/// What is listed beside neighbours does not change sums over a kernel whose support is the radius, since
/// it is zero there.
template <int Dim, class Space = OpenSpace<Dim>, class Real = double> class SkinLists {
    using Point = VecOf<Real, Dim>;
    using Given = std::span<const Point>;

public:
    /// Throws InvalidInput unless radius and skin are positive, and the skin is wider than distances of
    /// points as far apart as radius + skin are rounded.
    SkinLists(double radius, double skin, Space space = {})
        : space_{space}, grid_{space}, radius_{radius}, skin_{skin} {
        check_radius<Real>(space, radius);
        check_radius<Real>(space, radius + skin);
        limit_ = 0.5 * skin - rounding_error();
        if (!(skin > 0.0 && limit_ > 0.0))
            throw InvalidInput("SkinLists: expected a skin above 0 and above rounding, found " +
                               as_text(skin));
    }

    /// Makes the lists right for these points, which are those of the last call, moved, or others.
    /// Returns whether they had to be built again.
    bool update(Given points) {
        check_points(space_, points);
        if (points.size() == built_at_.size() && largest_move(points) < limit_) {
            now_.assign(points.begin(), points.end());
            return false;
        }
        build(points);
        return true;
    }
    /// The same, but always builds the lists again.
    void build(Given points) {
        grid_.build(points, radius_ + skin_);
        grid_.pack(lists_);
        built_at_.assign(points.begin(), points.end());
        now_ = built_at_;
    }
    /// At least the neighbours, at most the points that were closer than radius + skin when lists were
    /// built.
    const PackedLists& lists() const { return lists_; }

    /// The neighbours of all points as of the last update, and nothing else.
    void exact(PackedLists& neighbours) const {
        neighbours.restart(now_.size());
        const auto r = static_cast<Real>(radius_);
        parallel_for_parts(now_.size(), [&](std::size_t first, std::size_t last) {
            PackedLists::Writer writer(neighbours);
            for (std::size_t i = first; i < last; ++i) {
                const auto near = lists_.of(static_cast<Index>(i));
                Index* row = writer.room(near.size() + 1);
                std::size_t n = 0;
                for (const Index j : near) {
                    row[n] = j;
                    n += squared_distance(space_, now_[i], now_[j]) < r * r ? 1 : 0;
                }
                writer.add(static_cast<Index>(i), n);
            }
        });
    }

    double radius() const { return radius_; }
    double skin() const { return skin_; }
    std::size_t memory() const {
        return grid_.memory() + lists_.memory() +
               (built_at_.capacity() + now_.capacity()) * sizeof(Point);
    }

private:
    /// The farthest that a point is from where lists were built.
    double largest_move(Given points) const {
        std::mutex mutex;
        Real largest = 0;
        parallel_for_parts(points.size(), [&](std::size_t first, std::size_t last) {
            Real most = 0;
            for (std::size_t i = first; i < last; ++i)
                most = std::max(most, squared_distance(space_, points[i], built_at_[i]));
            const std::scoped_lock lock(mutex);
            largest = std::max(largest, most);
        });
        return std::sqrt(static_cast<double>(largest));
    }
    /// How much a distance of up to radius + skin, and a move, may be rounded together: squared_distance
    /// (space.h) errs by less than 4 units of rounding of the distance, and in a periodic box by Dim units
    /// of the edge.
    double rounding_error() const {
        constexpr double unit = sizeof(Real) == 8 ? 0x1p-53 : 0x1p-24;
        double longest = radius_ + skin_;
        if constexpr (Space::is_periodic) longest += space_.edge().maxCoeff();
        return 16.0 * unit * longest;
    }

    Space space_;
    CellGrid<Dim, Space, Real> grid_;
    double radius_, skin_, limit_;
    PackedLists lists_;
    std::vector<Point> built_at_, now_;
};

}  // namespace plumbline
