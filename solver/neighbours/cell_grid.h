#pragma once

#include "solver/neighbours/candidates.h"
#include "solver/neighbours/cell_order.h"
#include "solver/neighbours/cell_window.h"
#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

namespace plumbline {

/// The fast search for one radius: points and queries sorted by cell, so that all queries of a cell
/// share one gathered set of candidates, which are a few contiguous runs of points. Only occupied cells
/// are kept, so memory is O(n) however sparse the points are. After adams2009 Sec. 5.2, whose hash
/// table is replaced by the sorted cells.
template <int Dim, class Space = OpenSpace<Dim>>
class CellGrid : public Queries<CellGrid<Dim, Space>, Dim> {
public:
    static constexpr std::string_view name = "cell_grid";

    explicit CellGrid(Space space = {}) : space_{space} {}

    void build(std::span<const Vec<Dim>> points, double radius) {
        check_radius(space_, radius);
        check_points(space_, points);
        radius_ = radius;
        if constexpr (Space::is_periodic)
            frame_ = CellFrame<Dim>::filling(space_, radius);
        else
            frame_ = CellFrame<Dim>::around(points, radius);
        points_.sort(frame_, points);
    }

    /// Queries that are the points themselves are not sorted again.
    void find(std::span<const Vec<Dim>> queries, Radii radii, NeighbourLists& lists) const {
        if (points_.holds(queries)) return find(points_, radii, lists);
        CellOrder<Dim> sorted;
        sorted.sort(frame_, queries);
        find(sorted, radii, lists);
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t memory() const { return points_.memory(); }

private:
    /// Counts first, then writes each row where it belongs: no second copy of the lists is held.
    void find(const CellOrder<Dim>& queries, Radii radii, NeighbourLists& lists) const {
        lists.offsets.resize(queries.size() + 1);
        for_each_cell(queries, radii, [&](std::size_t k, const Candidates<Dim>& near) {
            const Index i = queries.order(k);
            const double r = radii.of(i);
            lists.offsets[i + 1] = count_within(space_, queries.position(k), r * r, near);
        });
        lay_out(lists);
        for_each_cell(queries, radii, [&](std::size_t k, Candidates<Dim>& near) {
            const Index i = queries.order(k);
            const double r = radii.of(i);
            const std::size_t n = collect_within(space_, queries.position(k), r * r, near);
            sort_ascending(near.within.data(), n, lists.indices.data() + lists.offsets[i]);
        });
    }

    /// Calls visit(k, candidates) for every query k of the sorted `queries`, cells in parallel.
    template <class Visit>
    void for_each_cell(const CellOrder<Dim>& queries, Radii radii, Visit visit) const {
        constexpr std::size_t block_size = 64;
        const std::size_t cells = queries.cells(), blocks = (cells + block_size - 1) / block_size;
        parallel_for(
            blocks,
            [&](std::size_t b) {
                CellWindow<Dim, Space::is_periodic> window(frame_, points_);
                Candidates<Dim> near;
                std::size_t row = queries.row_of(b * block_size);
                for (std::size_t c = b * block_size; c < std::min(cells, (b + 1) * block_size);
                     ++c) {
                    if (c == queries.first_cell(row + 1)) ++row;
                    const Index first = queries.first_point(c), last = queries.first_point(c + 1);
                    window.move_to(queries.row(row), queries.column(c),
                                   frame_.reach(largest(queries, radii, first, last)));
                    window.gather(near);
                    for (Index k = first; k < last; ++k) visit(k, near);
                }
            },
            1);
    }

    static double largest(const CellOrder<Dim>& queries, Radii radii, Index first, Index last) {
        double most = radii.of(queries.order(first));
        if (radii.vary())
            for (Index k = first + 1; k < last; ++k)
                most = std::max(most, radii.of(queries.order(k)));
        return most;
    }

    Space space_;
    double radius_ = 0.0;
    CellFrame<Dim> frame_;
    CellOrder<Dim> points_;
};

}  // namespace plumbline
