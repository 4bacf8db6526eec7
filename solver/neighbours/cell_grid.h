#pragma once

#include "solver/neighbours/candidates_simd.h"
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
    using Window = CellWindow<Dim, Space::is_periodic>;
    static constexpr std::size_t cells_per_block = 64;

    /// What the first pass over a block of cells hands to the second: which candidates are neighbours.
    using Bits = std::vector<std::uint64_t>;

    /// Tests first, then writes each row where it belongs; between the two, one bit is kept for each
    /// tested pair, not a second copy of the lists.
    void find(const CellOrder<Dim>& queries, Radii radii, NeighbourLists& lists) const {
        const Instructions instructions = best_instructions();
        std::vector<Bits> within((queries.cells() + cells_per_block - 1) / cells_per_block);
        lists.offsets.resize(queries.size() + 1);
        for_each_block(queries, radii, [&](std::size_t block, auto& for_each_cell) {
            Candidates<Dim> near;
            for_each_cell([&](const Window& window, Index first, Index last) {
                window.gather_positions(near);
                Bits& bits = within[block];
                std::size_t at = bits.size();
                bits.resize(at + (last - first) * near.words());
                for (Index k = first; k < last; ++k, at += near.words()) {
                    const Index i = queries.order(k);
                    const double r = radii.of(i);
                    lists.offsets[i + 1] = test_candidates(
                        instructions, space_, queries.position(k), r * r, near, bits.data() + at);
                }
            });
        });
        lay_out(lists);
        for_each_block(queries, radii, [&](std::size_t block, auto& for_each_cell) {
            Candidates<Dim> near;
            std::vector<Index> row;
            const std::uint64_t* bits = within[block].data();
            for_each_cell([&](const Window& window, Index first, Index last) {
                window.gather_ids(near);
                row.resize(std::max(row.size(), near.words() * 64 + room_to_sort));
                for (Index k = first; k < last; ++k, bits += near.words()) {
                    prefetch_row(queries, k + 8, lists);
                    const std::size_t n =
                        select_candidates(instructions, near.id(), near.words(), bits, row.data());
                    sort_ascending(row.data(), n,
                                   lists.indices.data() + lists.offsets[queries.order(k)]);
                }
            });
        });
    }

    /// Rows are written in the order of the cells, which is no order at all if the queries are not
    /// sorted: without this, waiting for memory takes longer than the search.
    static void prefetch_row(const CellOrder<Dim>& queries, std::size_t k, NeighbourLists& lists) {
        if (k >= queries.size()) return;
        const Index i = queries.order(k);
        constexpr std::size_t line = 64 / sizeof(Index), most = 8 * line;
        const std::size_t first = lists.offsets[i], last = lists.offsets[i + 1];
        for (std::size_t at = first; at < std::min(last, first + most); at += line)
            __builtin_prefetch(lists.indices.data() + at, 1);
    }

    /// Calls visit(block, for_each_cell) for blocks of cells of the sorted `queries`, in parallel.
    /// for_each_cell(f) calls f(window, first, last) with the queries first .. last of each cell.
    template <class Visit>
    void for_each_block(const CellOrder<Dim>& queries, Radii radii, Visit visit) const {
        const std::size_t cells = queries.cells();
        const auto walk = [&](std::size_t begin, auto& cell_visit) {
            Window window(frame_, points_);
            std::size_t row = queries.row_of(begin);
            for (std::size_t c = begin; c < std::min(cells, begin + cells_per_block); ++c) {
                if (c == queries.first_cell(row + 1)) ++row;
                const Index first = queries.first_point(c), last = queries.first_point(c + 1);
                window.move_to(queries.row(row), queries.column(c),
                               frame_.reach(largest(queries, radii, first, last)));
                cell_visit(window, first, last);
            }
        };
        parallel_for((cells + cells_per_block - 1) / cells_per_block,
                     [&](std::size_t b) {
                         const auto for_each_cell = [&](auto cell_visit) {
                             walk(b * cells_per_block, cell_visit);
                         };
                         visit(b, for_each_cell);
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
