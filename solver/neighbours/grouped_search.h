#pragma once

#include "solver/neighbours/candidates.h"
#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/packed_lists.h"
#include "solver/neighbours/queries.h"

#include <memory>

namespace plumbline {

/// Of the candidates of a query all, or those that come later in the sorted order.
enum class Part { all, later };

/// All forms of lists, for searches that sort the points so that neighbours are close in memory, and treat
/// queries in groups that share candidates. `Order` is the sorted points: order(k), size(), holds(points),
/// blocks(). The search has
///   sorted(queries) -> Order, if they are not the points;
///   points() -> const Order&, as built;
///   visit_block(block, queries, radii, part, visit), which calls visit(k, test) for each k of a block of the
///   sorted queries with the NearTest that tells its neighbours.
///
/// Lists come in two forms: NeighbourLists, ascending, and PackedLists, in the order of the candidates,
/// which take about half the time.
template <class Search, class Order, int Dim, class Space, class Real>
class GroupedSearch : public Queries<Search, Dim, Real> {
    using Point = VecOf<Real, Dim>;
    using Given = std::span<const Point>;

public:
    /// Queries that are the points themselves are not sorted again.
    void find(Given queries, Radii radii, NeighbourLists& lists) const {
        with_sorted(queries, [&](const Order& sorted) { fill(sorted, radii, lists); });
    }
    void find(Given queries, Radii radii, PackedLists& lists) const {
        with_sorted(queries, [&](const Order& sorted) { pack(sorted, radii, Part::all, lists); });
    }

    /// The neighbours of all points as built: row i is that of point i.
    void pack(PackedLists& lists) const { pack(self().points(), Radii(radius_), Part::all, lists); }
    /// The same with another radius than that of `build`, or one for each point. Lists do not
    /// depend on the radius of `build`, the time does.
    void pack(double radius, PackedLists& lists) const {
        check_radius<Real>(space_, radius);
        pack(self().points(), Radii(radius), Part::all, lists);
    }
    void pack(std::span<const double> radii, PackedLists& lists) const {
        this->check_radii(radii, self().points().size());
        pack(self().points(), Radii(radii), Part::all, lists);
    }
    /// Each pair of two points once, for loops that treat both at a time: in the row of the one that
    /// comes first in point_order(), so i < j if points are given in it.
    void pack_pairs(PackedLists& lists) const {
        pack(self().points(), Radii(radius_), Part::later, lists);
    }
    /// How many neighbours each point has, itself included; with the radius of `build`, or one of its own.
    void count(std::vector<Index>& counts) const { count(Radii(radius_), counts); }
    void count(std::span<const double> radii, std::vector<Index>& counts) const {
        this->check_radii(radii, self().points().size());
        count(Radii(radii), counts);
    }
    /// Calls visit(i, neighbours) for each point, in parallel and in no order, without storing lists;
    /// `neighbours` is the row of PackedLists, and is gone when visit returns.
    template <class Visit> void for_each_row(Visit visit) const {
        for_each_row(Radii(radius_), visit);
    }
    template <class Visit> void for_each_row(std::span<const double> radii, Visit visit) const {
        this->check_radii(radii, self().points().size());
        for_each_row(Radii(radii), visit);
    }

    /// How many distances pack(radii, …) computes: the work, whatever the machine.
    std::size_t distances(std::span<const double> radii) const {
        this->check_radii(radii, self().points().size());
        std::vector<std::size_t> of_block(self().points().blocks(), 0);
        search(self().points(), Radii(radii), Part::all, [&](std::size_t block) {
            return [&all = of_block[block]](std::size_t, const NearTest<Real>& test) {
                all += test.size;
            };
        });
        return std::accumulate(of_block.begin(), of_block.end(), std::size_t{0});
    }

    /// The sorted points: the k-th was given as point point_order()[k]. Arrays in this order make loops
    /// over neighbours fast.
    std::span<const Index> point_order() const {
        return {self().points().order(), self().points().size()};
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }

protected:
    GroupedSearch(const Space& space, Instructions instructions)
        : space_{space}, near_{near_functions<Real>(instructions, Dim, Space::is_periodic)} {}

    /// To be called by `build` first.
    void check(Given points, double radius) {
        check_radius<Real>(space_, radius);
        check_points(space_, points);
        radius_ = radius;
    }

    /// Queries that share candidates: first .. last of those sorted, and the largest of their radii.
    struct Group {
        Index first, last;
        double radius;
    };
    template <class Sorted>
    static Group group_of(const Sorted& queries, Index first, Index last, Radii radii) {
        Group group{first, last, radii.of(queries.order(first))};
        for (Index k = first + 1; k < last && radii.vary(); ++k)
            group.radius = std::max(group.radius, radii.of(queries.order(k)));
        return group;
    }
    struct Corners {
        Point low, high;
    };
    template <class Sorted> static Corners box_of(const Group& group, const Sorted& queries) {
        Corners box{queries.position(group.first), queries.position(group.first)};
        for (Index k = group.first + 1; k < group.last; ++k) {
            const Point x = queries.position(k);
            box.low = box.low.cwiseMin(x);
            box.high = box.high.cwiseMax(x);
        }
        return box;
    }

    /// Visits the queries of a group, which come first among the candidates if Part is `later`; `before` is
    /// how many queries come before those sorted in `queries`. Where many share the candidates, these are
    /// looked through first: those that are far from all of the group are dropped.
    template <class Sorted, class Visit>
    void visit_group(const Group& group, const Sorted& queries, Radii radii, Part part,
                     Candidates<Dim, Real>& near, Visit& visit, Index before = 0) const {
        constexpr Index many = 12;
        if (group.last - group.first >= many) {
            const Corners box = box_of(group, queries);
            const auto radius = static_cast<Real>(group.radius);
            near.keep_near(near_, space_, box.low, box.high, radius * radius);
            if constexpr (sizeof(Real) == sizeof(double) && !Space::is_periodic)
                near.round(box.low, box.high);
        }
        for (Index k = group.first; k < group.last; ++k) {
            const auto r = static_cast<Real>(radii.of(queries.order(k)));
            const std::size_t from = part == Part::all ? 0 : k - group.first + 1;
            visit(before + k, near.near(space_, queries.position(k), r * r, from));
        }
    }

    Space space_;

private:
    const Search& self() const { return static_cast<const Search&>(*this); }

    template <class Use> void with_sorted(Given queries, Use use) const {
        if (self().points().holds(queries)) return use(self().points());
        use(self().sorted(queries));
    }

    void count(Radii radii, std::vector<Index>& counts) const {
        counts.resize(self().points().size());
        search(self().points(), radii, Part::all, [&](std::size_t) {
            return [&](std::size_t k, const NearTest<Real>& test) {
                counts[self().points().order(k)] = static_cast<Index>(near_.mark(test, nullptr));
            };
        });
    }
    template <class Visit> void for_each_row(Radii radii, Visit& visit) const {
        search(self().points(), radii, Part::all, [&](std::size_t) {
            return
                [&, row = std::vector<Index>()](std::size_t k, const NearTest<Real>& test) mutable {
                    row.resize(std::max(row.size(), test.size + candidates_per_step));
                    const std::size_t n = near_.select(test, row.data());
                    visit(self().points().order(k), std::span<const Index>(row.data(), n));
                };
        });
    }
    void pack(const Order& queries, Radii radii, Part part, PackedLists& lists) const {
        lists.restart(queries.size());
        search(queries, radii, part, [&](std::size_t) {
            return [&, writer = std::make_unique<PackedLists::Writer>(lists)](
                       std::size_t k, const NearTest<Real>& test) {
                constexpr std::size_t ahead = 16;
                if (k + ahead < queries.size()) writer->expect(queries.order(k + ahead));
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
        std::vector<std::vector<std::uint16_t>> marks(queries.blocks());
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

    /// Calls visit(k, test) for the k-th of the sorted queries with the test that tells its neighbours.
    /// Blocks are visited in parallel, each by a make_visit(block).
    template <class MakeVisit>
    void search(const Order& queries, Radii radii, Part part, MakeVisit make_visit) const {
        parallel_for(
            queries.blocks(),
            [&](std::size_t b) {
                auto visit = make_visit(b);
                self().visit_block(b, queries, radii, part, visit);
            },
            1);
    }

    NearFunctions<Real> near_;
    double radius_ = 0.0;
};

}  // namespace plumbline
