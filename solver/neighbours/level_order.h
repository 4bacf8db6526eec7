#pragma once

#include "solver/neighbours/cell_order.h"

namespace plumbline {

/// Points in the cells of several grids, each with cells half as wide as those of the one before: a point
/// is in the first grid in which its cell is not crowded. So cells are wide where points are sparse, and
/// narrow where they are dense. O(n) for each width.
template <int Dim, class Space, class Real> class LevelOrder {
    using Point = VecOf<Real, Dim>;
    using Given = std::span<const Point>;

public:
    using Cells = CellOrder<Dim, Real>;

    /// A cell with more points is crowded, unless it is as narrow as cells may be.
    static constexpr Index most_points = 24;

    struct Level {
        CellFrame<Dim> frame;
        Cells points;
        Cells crowded;  // one point of each crowded cell: points of later levels are only there
        Index first;    // of its points in the order of all
        std::size_t first_block;
    };

    /// The widest cells are a quarter of the box of the points, or 256 radii.
    void sort(const Space& space, Given points, double radius) {
        constexpr int halvings = 24;
        const double edge = longest_edge(points);
        double width = edge > 0.0 ? std::min(256.0 * radius, edge / 4.0) : radius;
        take(points);
        for (int k = edge > 0.0 ? 0 : halvings; !rest_.points.empty(); ++k, width /= 2.0)
            add_level(space, width, k >= halvings);
        levels_.resize(used_);
    }

    bool holds(Given points) const {
        if (points.size() != size()) return false;
        for (const Level& level : levels_)
            for (std::size_t k = 0; k < level.points.size(); ++k)
                if (points[level.points.order(k)] != level.points.position(k)) return false;
        return true;
    }

    /// Points are numbered level after level, in a level cell after cell.
    std::size_t size() const { return order_.size(); }
    Index order(std::size_t k) const { return order_[k]; }
    const Index* order() const { return order_.data(); }

    std::size_t levels() const { return levels_.size(); }
    const Level& level(std::size_t l) const { return levels_[l]; }
    std::size_t blocks() const {
        return levels_.empty() ? 0 : levels_.back().first_block + levels_.back().points.blocks();
    }
    std::size_t level_of_block(std::size_t block) const {
        std::size_t l = levels() - 1;
        while (levels_[l].first_block > block) --l;
        return l;
    }

    /// Bytes held, those kept for the next sort included.
    std::size_t memory() const {
        const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
        std::size_t all = bytes(order_) + bytes(heads_);
        for (const Some* some : {&rest_, &kept_, &passed_})
            all += bytes(some->points) + bytes(some->numbers);
        for (const Level& level : levels_) all += level.points.memory() + level.crowded.memory();
        return all;
    }

private:
    /// Some of the points, and as what number each was given.
    struct Some {
        std::vector<Point> points;
        std::vector<Index> numbers;

        void clear() { points.clear(), numbers.clear(); }
        void add(const Some& from, Index i) {
            points.push_back(from.points[i]);
            numbers.push_back(from.numbers[i]);
        }
    };

    static double longest_edge(Given points) {
        if (points.empty()) return 0.0;
        Point low = points.front(), high = low;
        for (const Point& x : points) low = low.cwiseMin(x), high = high.cwiseMax(x);
        return (high.template cast<double>() - low.template cast<double>()).maxCoeff();
    }

    void take(Given points) {
        used_ = 0;
        order_.clear();
        rest_.points.assign(points.begin(), points.end());
        rest_.numbers.resize(points.size());
        std::iota(rest_.numbers.begin(), rest_.numbers.end(), Index{0});
    }

    /// Moves those of the rest whose cells are not crowded into a level; none if they are few, since they
    /// can as well be in narrower cells.
    void add_level(const Space& space, double width, bool is_last) {
        constexpr std::size_t least_share = 1000;
        if (used_ == levels_.size()) levels_.emplace_back();
        Level& level = levels_[used_];
        level.frame = frame(space, width);
        level.points.sort(level.frame, rest_.points);
        part(level.points, is_last);
        if (passed_.points.empty()) {
            level.crowded.sort(level.frame, {});
            close(level, rest_.numbers);
            rest_.clear();
        } else if (least_share * kept_.points.size() > rest_.points.size()) {
            level.crowded.sort(level.frame, heads_);
            level.points.sort(level.frame, kept_.points);
            close(level, kept_.numbers);
            std::swap(rest_, passed_);
        }
    }
    CellFrame<Dim> frame(const Space& space, double width) const {
        constexpr double rounding = sizeof(Real) == 8 ? 0x1p-53 : 0x1p-24;
        if constexpr (Space::is_periodic)
            return CellFrame<Dim>::filling(space, width, rounding);
        else
            return CellFrame<Dim>::around(Given(rest_.points), width);
    }
    /// Parts the rest into those that are kept and those that are passed on.
    void part(const Cells& cells, bool is_last) {
        kept_.clear(), passed_.clear(), heads_.clear();
        for (std::size_t c = 0; c < cells.cells(); ++c) {
            const Index first = cells.first_point(c), last = cells.first_point(c + 1);
            const bool crowded = last - first > most_points && !is_last;
            if (crowded) heads_.push_back(cells.position(first));
            for (Index k = first; k < last; ++k)
                (crowded ? passed_ : kept_).add(rest_, cells.order(k));
        }
    }
    void close(Level& level, const std::vector<Index>& numbers) {
        level.points.rename(numbers);
        level.first = static_cast<Index>(order_.size());
        level.first_block =
            used_ == 0 ? 0 : levels_[used_ - 1].first_block + levels_[used_ - 1].points.blocks();
        order_.insert(order_.end(), level.points.order(),
                      level.points.order() + level.points.size());
        ++used_;
    }

    std::vector<Level> levels_;
    std::size_t used_ = 0;
    std::vector<Index> order_;   // point k in this order was given as order_[k]
    Some rest_, kept_, passed_;  // kept for the next sort: new memory costs more than the sort
    std::vector<Point> heads_;   // of crowded cells
};

}  // namespace plumbline
