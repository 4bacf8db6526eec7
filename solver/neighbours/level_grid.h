#pragma once

#include "solver/neighbours/cell_window.h"
#include "solver/neighbours/grouped_search.h"
#include "solver/neighbours/level_order.h"

#include <concepts>

namespace plumbline {

/// A grid of several levels for radii or densities that vary strongly: points are sorted into cells that are
/// narrower where they are denser (level_order.h), and all queries of a cell share the candidates that are
/// within the largest of their radii, gathered from each level. After the hierarchical grids of Ericson 2005,
/// Sec. 7.2, with points in place of bodies: what sets the level is not a size, but how close they lie.
/// A kd-tree for the same task (leaf_tree.h) is built in O(n log n), this in O(n) for each level.
///
/// `build` with a radius typical of those that will be asked. The order of its PackedLists is: by level, from
/// wide cells to narrow ones, and as in CellGrid in each.
template <int Dim, class Space = OpenSpace<Dim>, class Real = double>
class LevelGrid : public GroupedSearch<LevelGrid<Dim, Space, Real>, LevelOrder<Dim, Space, Real>,
                                       Dim, Space, Real> {
    using Given = std::span<const VecOf<Real, Dim>>;
    using Order = LevelOrder<Dim, Space, Real>;
    using Base = GroupedSearch<LevelGrid, Order, Dim, Space, Real>;
    friend Base;

public:
    static constexpr std::string_view name = "level_grid";

    LevelGrid() requires std::default_initializable<Space> : LevelGrid(Space{}) {}
    explicit LevelGrid(Space space, Instructions instructions = best_instructions())
        : Base{space, instructions} {}

    void build(Given points, double radius) {
        this->check(points, radius);
        points_.sort(space_, points, radius);
    }

    std::size_t levels() const { return points_.levels(); }
    std::size_t memory() const { return points_.memory(); }

private:
    using Base::space_;
    using Group = typename Base::Group;
    using Corners = typename Base::Corners;
    using Level = typename Order::Level;
    using Window = CellWindow<Dim, Space::is_periodic, Real>;

    const Order& points() const { return points_; }
    Order sorted(Given queries) const {
        Order order;
        order.sort(space_, queries, this->radius());
        return order;
    }

    /// A block of cells moved through a level.
    struct LevelWindows {
        explicit LevelWindows(const Level& level)
            : points{level.frame, level.points}, crowded{level.frame, level.crowded} {}
        Window points, crowded;
    };

    template <class Visit>
    void visit_block(std::size_t block, const Order& queries, Radii radii, Part part,
                     Visit& visit) const {
        const std::size_t own = queries.level_of_block(block);
        const Level& level = queries.level(own);
        std::vector<LevelWindows> windows;
        for (std::size_t l = 0; l < points_.levels(); ++l) windows.emplace_back(points_.level(l));
        Candidates<Dim, Real> near;
        level.points.for_each_group(block - level.first_block, [&](const GroupOfCells& cells) {
            const Group group = Base::group_of(level.points, cells.first, cells.last, radii);
            const auto box = Base::box_of(group, level.points);
            if (part == Part::all)
                gather(group, box, own, windows, near);
            else
                gather_later(group, box, own, windows, near);
            this->visit_group(group, level.points, radii, part, near, visit, level.first);
        });
    }

    /// Those of all levels. If the queries are the points, the group's own cells are crowded in all levels
    /// before theirs; in later ones there is nothing to look for unless a cell within reach is crowded.
    void gather(const Group& group, const Corners& box, std::size_t own,
                std::vector<LevelWindows>& windows, Candidates<Dim, Real>& near) const {
        near.resize(0);
        for (std::size_t l = 0; l < windows.size(); ++l) {
            const auto block = block_around(box, group.radius, l);
            if (is_large(block, l)) {
                append_from(0, points_.level(l).points, near);
                continue;
            }
            windows[l].points.move_to(block);
            windows[l].points.append(near);
            if (l >= own && is_the_last(block, l, windows)) break;
        }
        near.close();
    }
    /// Of its own level those from its first on, and those of later levels.
    void gather_later(const Group& group, const Corners& box, std::size_t own,
                      std::vector<LevelWindows>& windows, Candidates<Dim, Real>& near) const {
        near.resize(0);
        for (std::size_t l = own; l < windows.size(); ++l) {
            const auto block = block_around(box, group.radius, l);
            if (is_large(block, l)) {
                append_from(l == own ? group.first : 0, points_.level(l).points, near);
                continue;
            }
            windows[l].points.move_to(block);
            if (l == own)
                windows[l].points.gather_from(group.first, near);
            else
                windows[l].points.append(near);
            if (is_the_last(block, l, windows)) break;
        }
        near.close();
    }
    static bool is_the_last(const CellBlock<Dim>& block, std::size_t l,
                            std::vector<LevelWindows>& windows) {
        windows[l].crowded.move_to(block);
        return windows[l].crowded.is_empty();
    }
    /// Whether a block has more rows than there are in the level: then all points of the level are taken.
    bool is_large(const CellBlock<Dim>& block, std::size_t l) const {
        constexpr double few = 64.0;
        double rows = 1.0;
        for (int axis = 1; axis < Dim; ++axis) {
            const std::int64_t cells = points_.level(l).frame.cells(axis);
            std::int64_t first = block.first[axis], last = block.last[axis];
            if (!Space::is_periodic)
                first = std::max<std::int64_t>(first, 0), last = std::min(last, cells - 1);
            rows *= static_cast<double>(std::min(cells, last - first + 1));
        }
        return rows > std::max(few, static_cast<double>(points_.level(l).points.rows()));
    }
    static void append_from(Index first, const typename Order::Cells& points,
                            Candidates<Dim, Real>& near) {
        const std::size_t to = near.size(), n = points.size() - first;
        near.resize(to + n);
        for (int axis = 0; axis < Dim; ++axis)
            std::copy_n(points.x(axis) + first, n, near.x(axis) + to);
        std::copy_n(points.order() + first, n, near.id() + to);
    }
    /// The cells of a level within reach of a group's box.
    CellBlock<Dim> block_around(const Corners& box, double radius, std::size_t l) const {
        const CellFrame<Dim>& frame = points_.level(l).frame;
        const auto low = frame.cell(box.low), high = frame.cell(box.high);
        const std::int64_t reach = frame.reach(radius);
        CellBlock<Dim> block;
        for (int axis = 0; axis < Dim; ++axis) {
            block.first[axis] = low[axis] - reach;
            block.last[axis] = high[axis] + reach;
        }
        return block;
    }

    Order points_;
};

}  // namespace plumbline
