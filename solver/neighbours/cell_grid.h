#pragma once

#include "solver/neighbours/cell_order.h"
#include "solver/neighbours/cell_window.h"
#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/packed_lists.h"
#include "solver/neighbours/queries.h"

namespace plumbline {

/// The fast search for one radius: points and queries sorted by cell, so that all queries of a cell
/// share one gathered set of candidates, which are a few contiguous runs of points. Only occupied cells
/// are kept, so memory is O(n) however sparse the points are. After adams2009 Sec. 5.2, whose hash
/// table is replaced by the sorted cells.
///
/// Lists come in two forms: NeighbourLists, ascending, and PackedLists, as found, which takes about
/// half the time. As found means: by row of cells, in a row by column, in a cell as given; in a
/// periodic box a row may begin in its middle.
/// With Real = float positions are given, and distances decided, in single precision: lists are those
/// of BruteForce<Dim, Space, float>.
template <int Dim, class Space = OpenSpace<Dim>, class Real = double>
class CellGrid : public Queries<CellGrid<Dim, Space, Real>, Dim, Real> {
    using Given = std::span<const VecOf<Real, Dim>>;

public:
    static constexpr std::string_view name = "cell_grid";

    explicit CellGrid(Space space = {}, Instructions instructions = best_instructions())
        : space_{space}, near_{near_functions<Real>(instructions, Dim, Space::is_periodic)} {}

    void build(Given points, double radius) {
        check_radius<Real>(space_, radius);
        check_points(space_, points);
        radius_ = radius;
        sort(points, radius);
        // Narrower cells follow the ball more closely; they pay where even these hold many points.
        const double points_per_cell =
            static_cast<double>(points_.size()) / static_cast<double>(points_.cells());
        constexpr double crowded = 5.0 * (1 << Dim);
        if (points_per_cell > crowded) sort(points, radius / 2.0);
    }

    /// Queries that are the points themselves are not sorted again.
    void find(Given queries, Radii radii, NeighbourLists& lists) const {
        with_sorted(queries, [&](const Order& sorted) { fill(sorted, radii, lists); });
    }
    void find(Given queries, Radii radii, PackedLists& lists) const {
        with_sorted(queries, [&](const Order& sorted) { pack(sorted, radii, Part::all, lists); });
    }

    /// The neighbours of all points as built: row i is that of point i.
    void pack(PackedLists& lists) const { pack(points_, Radii(radius_), Part::all, lists); }
    /// The same with another radius than that of `build`, or one for each point. A smaller one tests
    /// more candidates than a grid built for it, a larger one more cells; lists do not depend on it.
    void pack(double radius, PackedLists& lists) const {
        check_radius<Real>(space_, radius);
        pack(points_, Radii(radius), Part::all, lists);
    }
    void pack(std::span<const double> radii, PackedLists& lists) const {
        this->check_radii(radii, points_.size());
        pack(points_, Radii(radii), Part::all, lists);
    }
    /// Each pair of two points once, for loops that treat both at a time: in the row of the one that
    /// comes first in the order of the cells (point_order()), so i < j if points are given in it.
    void pack_pairs(PackedLists& lists) const { pack(points_, Radii(radius_), Part::later, lists); }
    /// How many neighbours each point has, itself included.
    void count(std::vector<Index>& counts) const {
        counts.resize(points_.size());
        search(points_, Radii(radius_), Part::all, [&](std::size_t) {
            return [&](std::size_t k, const NearTest<Real>& test) {
                counts[points_.order(k)] = static_cast<Index>(near_.mark(test, nullptr));
            };
        });
    }
    /// Calls visit(i, neighbours) for each point, in parallel and in no order, without storing lists;
    /// `neighbours` is the row of PackedLists, and is gone when visit returns.
    template <class Visit> void for_each_row(Visit visit) const {
        search(points_, Radii(radius_), Part::all, [&](std::size_t) {
            return
                [&, row = std::vector<Index>()](std::size_t k, const NearTest<Real>& test) mutable {
                    row.resize(std::max(row.size(), test.size + candidates_per_step));
                    const std::size_t n = near_.select(test, row.data());
                    visit(points_.order(k), std::span<const Index>(row.data(), n));
                };
        });
    }

    /// The points by cell: the k-th was given as point point_order()[k]. Arrays in this order make
    /// loops over neighbours fast.
    std::span<const Index> point_order() const { return {points_.order(), points_.size()}; }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t memory() const { return points_.memory(); }

private:
    using Order = CellOrder<Dim, Real>;
    using Window = CellWindow<Dim, Space::is_periodic, Real>;
    enum class Part { all, later };  // neighbours: all, or those later in the order of the cells

    void sort(Given points, double cell_width) {
        constexpr double rounding = sizeof(Real) == 8 ? 0x1p-53 : 0x1p-24;
        if constexpr (Space::is_periodic)
            frame_ = CellFrame<Dim>::filling(space_, cell_width, rounding);
        else
            frame_ = CellFrame<Dim>::around(points, cell_width);
        points_.sort(frame_, points);
    }

    template <class Use> void with_sorted(Given queries, Use use) const {
        if (points_.holds(queries)) return use(points_);
        Order sorted;
        sorted.sort(frame_, queries);
        use(sorted);
    }

    void pack(const Order& queries, Radii radii, Part part, PackedLists& lists) const {
        lists.restart(queries.size());
        search(queries, radii, part, [&](std::size_t) {
            return [&, writer = std::make_unique<PackedLists::Writer>(lists)](
                       std::size_t k, const NearTest<Real>& test) {
                Index* row = writer->room(test.size - test.from + candidates_per_step);
                const std::size_t n = near_.select(test, row);
                writer->add(queries.order(k), n);
                prefetch_for_writing(row + n, n);
            };
        });
    }
    /// Rows are written faster than the processor expects: it is told where the next ones will be.
    static void prefetch_for_writing(const Index* row, std::size_t n) {
        constexpr std::size_t line = 64 / sizeof(Index), ahead = 16 * line;
        for (std::size_t k = 0; k < n + line; k += line) __builtin_prefetch(row + ahead + k, 1);
    }

    /// Tests first, then writes each row where it belongs; between the two, one bit is kept for each
    /// tested pair, not a second copy of the lists.
    void fill(const Order& queries, Radii radii, NeighbourLists& lists) const {
        std::vector<std::vector<std::uint16_t>> marks(blocks_of(queries));
        lists.offsets.resize(queries.size() + 1);
        search(queries, radii, Part::all, [&](std::size_t block) {
            return [&, &bits = marks[block]](std::size_t k, const NearTest<Real>& test) {
                const std::size_t at = bits.size();
                bits.resize(at + steps(test));
                lists.offsets[queries.order(k) + 1] = near_.mark(test, bits.data() + at);
            };
        });
        lay_out(lists);
        search(queries, radii, Part::all, [&](std::size_t block) {
            return [&, bits = marks[block].data(), row = std::vector<Index>()](
                       std::size_t k, const NearTest<Real>& test) mutable {
                row.resize(std::max(row.size(), test.size + room_to_sort));
                prefetch_row(queries, k + 8, lists);
                const std::size_t n = near_.take(test, bits, row.data());
                bits += steps(test);
                sort_ascending(row.data(), n,
                               lists.indices.data() + lists.offsets[queries.order(k)]);
            };
        });
    }
    static std::size_t steps(const NearTest<Real>& test) {
        return (test.size + candidates_per_step - 1) / candidates_per_step;
    }
    /// Rows are written in the order of the cells, which is no order at all if the queries are not
    /// sorted: without this, waiting for memory takes longer than the search.
    static void prefetch_row(const Order& queries, std::size_t k, NeighbourLists& lists) {
        if (k >= queries.size()) return;
        const Index i = queries.order(k);
        constexpr std::size_t line = 64 / sizeof(Index), most = 8 * line;
        const std::size_t first = lists.offsets[i], last = lists.offsets[i + 1];
        for (std::size_t at = first; at < std::min(last, first + most); at += line)
            __builtin_prefetch(lists.indices.data() + at, 1);
    }

    /// Calls visit(k, test) for the k-th of the sorted queries with the test that tells its neighbours,
    /// cell after cell. Blocks of cells are visited in parallel, each by a make_visit(block).
    template <class MakeVisit>
    void search(const Order& queries, Radii radii, Part part, MakeVisit make_visit) const {
        parallel_for(
            blocks_of(queries),
            [&](std::size_t b) {
                auto visit = make_visit(b);
                const std::size_t begin = b * cells_per_block;
                visit_cells(queries, radii, part, begin,
                            std::min(queries.cells(), begin + cells_per_block), visit);
            },
            1);
    }
    static constexpr std::size_t cells_per_block = 64;
    static std::size_t blocks_of(const Order& queries) {
        return (queries.cells() + cells_per_block - 1) / cells_per_block;
    }
    template <class Visit>
    void visit_cells(const Order& queries, Radii radii, Part part, std::size_t begin,
                     std::size_t end, Visit& visit) const {
        Window window(frame_, points_);
        Candidates<Dim, Real> near;
        std::size_t row = queries.row_of(begin);
        for (std::size_t c = begin, next; c < end; c = next) {
            if (c == queries.first_cell(row + 1)) ++row;
            next =
                end_of_group(queries, c, std::min<std::size_t>(end, queries.first_cell(row + 1)));
            const Index first = queries.first_point(c), last = queries.first_point(next);
            window.move_to(queries.row(row), queries.column(c), queries.column(next - 1),
                           frame_.reach(largest(queries, radii, first, last)));
            if (part == Part::all)
                window.gather(near);
            else
                window.gather_from(first, near);
            for (Index k = first; k < last; ++k) {
                const auto r = static_cast<Real>(radii.of(queries.order(k)));
                const std::size_t from = part == Part::all ? 0 : k - first + 1;
                visit(k, near.near(space_, queries.position(k), r * r, from));
            }
        }
    }
    /// Cells with few points share the candidates of up to four columns of a row.
    static std::size_t end_of_group(const Order& queries, std::size_t begin, std::size_t end) {
        constexpr std::uint32_t most_columns = 4, enough_points = 6;
        std::size_t next = begin + 1;
        while (next < end && queries.column(next) - queries.column(begin) < most_columns &&
               queries.first_point(next) - queries.first_point(begin) < enough_points)
            ++next;
        return next;
    }

    static double largest(const Order& queries, Radii radii, Index first, Index last) {
        double most = radii.of(queries.order(first));
        if (radii.vary())
            for (Index k = first + 1; k < last; ++k)
                most = std::max(most, radii.of(queries.order(k)));
        return most;
    }

    Space space_;
    NearFunctions<Real> near_;
    double radius_ = 0.0;
    CellFrame<Dim> frame_;
    Order points_;
};

}  // namespace plumbline
