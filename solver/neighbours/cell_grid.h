#pragma once

#include "solver/neighbours/cell_order.h"
#include "solver/neighbours/cell_window.h"
#include "solver/neighbours/grouped_search.h"

#include <concepts>

namespace plumbline {

/// The fast search for one radius: points and queries sorted by cell, so that all queries of a cell
/// share one gathered set of candidates, which are a few contiguous runs of points. Only occupied cells
/// are kept, so memory is O(n) however sparse the points are. After adams2009 Sec. 5.2, whose hash
/// table is replaced by the sorted cells.
///
/// The order of its PackedLists is: by row of cells, in a row by column, in a cell as given; in a
/// periodic box a row may begin in its middle. For another radius than that of the grid a smaller one tests
/// more candidates than a grid built for it, a larger one visits more cells.
/// With Real = float positions are given, and distances decided, in single precision: lists are those
/// of BruteForce<Dim, Space, float>.
template <int Dim, class Space = OpenSpace<Dim>, class Real = double>
class CellGrid
    : public GroupedSearch<CellGrid<Dim, Space, Real>, CellOrder<Dim, Real>, Dim, Space, Real> {
    using Given = std::span<const VecOf<Real, Dim>>;
    using Order = CellOrder<Dim, Real>;
    using Base = GroupedSearch<CellGrid, Order, Dim, Space, Real>;
    friend Base;

public:
    static constexpr std::string_view name = "cell_grid";

    CellGrid() requires std::default_initializable<Space> : CellGrid(Space{}) {}
    explicit CellGrid(Space space, Instructions instructions = best_instructions())
        : Base{space, instructions} {}

    void build(Given points, double radius) {
        this->check(points, radius);
        sort(points, radius);
        // Narrower cells follow the ball more closely; they pay where even these hold many points.
        const double points_per_cell =
            static_cast<double>(points_.size()) / static_cast<double>(points_.cells());
        constexpr double crowded = 5.0 * (1 << Dim);
        if (points_per_cell > crowded) sort(points, radius / 2.0);
    }

    std::size_t memory() const { return points_.memory(); }

private:
    using Window = CellWindow<Dim, Space::is_periodic, Real>;
    using Base::space_;

    void sort(Given points, double cell_width) {
        constexpr double rounding = sizeof(Real) == 8 ? 0x1p-53 : 0x1p-24;
        if constexpr (Space::is_periodic)
            frame_ = CellFrame<Dim>::filling(space_, cell_width, rounding);
        else
            frame_ = CellFrame<Dim>::around(points, cell_width);
        points_.sort(frame_, points);
    }

    const Order& points() const { return points_; }
    Order sorted(Given queries) const {
        Order order;
        order.sort(frame_, queries);
        return order;
    }

    template <class Visit>
    void visit_block(std::size_t block, const Order& queries, Radii radii, Part part,
                     Visit& visit) const {
        Window window(frame_, points_);
        Candidates<Dim, Real> near;
        queries.for_each_group(block, [&](const GroupOfCells& cells) {
            const auto group = Base::group_of(queries, cells.first, cells.last, radii);
            window.move_to(cells.row, cells.first_column, cells.last_column,
                           frame_.reach(group.radius));
            if (part == Part::all)
                window.gather(near);
            else
                window.gather_from(group.first, near);
            this->visit_group(group, queries, radii, part, near, visit);
        });
    }

    CellFrame<Dim> frame_;
    Order points_;
};

}  // namespace plumbline
