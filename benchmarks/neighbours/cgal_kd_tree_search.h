#pragma once

#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <memory>

namespace benchmarks {

/// The kd-tree of CGAL, behind our concept, in double precision and with CGAL's default splitter and
/// bucket. The query is our own: Fuzzy_sphere is closed, neighbours are strictly inside.
template <int Dim>
requires(Dim == 2 || Dim == 3) class CgalKdTreeSearch
    : public plumbline::Queries<CgalKdTreeSearch<Dim>, Dim> {
public:
    static constexpr std::string_view name = "cgal_kd_tree";

    void build(std::span<const plumbline::Vec<Dim>> points, double radius) {
        plumbline::check_radius(space_, radius);
        plumbline::check_points(space_, points);
        radius_ = radius;
        std::vector<Entry> entries;
        for (plumbline::Index i = 0; i < points.size(); ++i)
            entries.emplace_back(as_point(points[i]), i);
        tree_ = std::make_unique<Tree>(entries.begin(), entries.end());
        if (!entries.empty()) tree_->build();
    }
    void find(std::span<const plumbline::Vec<Dim>> queries, plumbline::Radii radii,
              plumbline::NeighbourLists& lists) const {
        plumbline::fill_lists(queries.size(), lists,
                              [&](std::size_t i, std::vector<plumbline::Index>& row) {
                                  if (!tree_ || tree_->empty()) return;
                                  const double r = radii.of(i);
                                  tree_->search(Numbers{&row}, OpenBall{queries[i], r * r});
                              });
    }

    const plumbline::OpenSpace<Dim>& space() const { return space_; }
    double radius() const { return radius_; }
    /// The points and their numbers; CGAL does not tell the size of its nodes.
    std::size_t memory() const { return tree_ ? tree_->size() * 2 * sizeof(Entry) : 0; }

private:
    using Kernel = CGAL::Simple_cartesian<double>;
    using Point = std::conditional_t<Dim == 2, Kernel::Point_2, Kernel::Point_3>;
    using PointTraits =
        std::conditional_t<Dim == 2, CGAL::Search_traits_2<Kernel>, CGAL::Search_traits_3<Kernel>>;
    using Entry = std::pair<Point, plumbline::Index>;
    using Traits =
        CGAL::Search_traits_adapter<Entry, CGAL::First_of_pair_property_map<Entry>, PointTraits>;
    using Tree = CGAL::Kd_tree<Traits>;

    static Point as_point(const plumbline::Vec<Dim>& x) {
        if constexpr (Dim == 2)
            return {x[0], x[1]};
        else
            return {x[0], x[1], x[2]};
    }

    /// A query item of CGAL: the points strictly closer than the radius. The tree need not ask about
    /// points of a box that is inside, hence the room for rounding.
    struct OpenBall {
        using D = typename Traits::Dimension;
        plumbline::Vec<Dim> centre;
        double squared_radius;

        bool contains(const Entry& entry) const {
            double total = 0.0;
            for (int axis = 0; axis < Dim; ++axis) {
                const double d = centre[axis] - entry.first[axis];
                total += d * d;
            }
            return total < squared_radius;
        }
        bool inner_range_intersects(const CGAL::Kd_tree_rectangle<double, D>& box) const {
            double total = 0.0;
            for (int axis = 0; axis < Dim; ++axis) {
                const double gap = std::max(
                    {box.min_coord(axis) - centre[axis], centre[axis] - box.max_coord(axis), 0.0});
                total += gap * gap;
            }
            return total < squared_radius;
        }
        bool outer_range_contains(const CGAL::Kd_tree_rectangle<double, D>& box) const {
            double total = 0.0;
            for (int axis = 0; axis < Dim; ++axis) {
                const double reach = std::max(std::abs(box.max_coord(axis) - centre[axis]),
                                              std::abs(centre[axis] - box.min_coord(axis)));
                total += reach * reach;
            }
            return total < squared_radius;
        }
    };
    /// An output iterator that keeps the number of a point.
    struct Numbers {
        std::vector<plumbline::Index>* row;
        Numbers& operator*() { return *this; }
        Numbers& operator++() { return *this; }
        Numbers operator++(int) { return *this; }
        Numbers& operator=(const Entry& entry) {
            row->push_back(entry.second);
            return *this;
        }
    };

    plumbline::OpenSpace<Dim> space_;
    double radius_ = 0.0;
    std::unique_ptr<Tree> tree_;
};

}  // namespace benchmarks
