#pragma once

#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/packed_lists.h"
#include "solver/neighbours/queries.h"

#include <nanoflann.hpp>

#include <memory>

namespace benchmarks {

/// How many points a leaf of nanoflann's tree may hold: its default, and what is the fastest on jittered
/// lattices.
inline constexpr std::size_t nanoflann_default_leaf = 10, nanoflann_tuned_leaf = 16;

/// The kd-tree of nanoflann, behind our concept. Its distance is summed like squared_distance, and its
/// results go straight into the row, so that it does no more than its own work.
template <int Dim, std::size_t Leaf = nanoflann_tuned_leaf>
class NanoflannSearch : public plumbline::Queries<NanoflannSearch<Dim, Leaf>, Dim> {
public:
    static constexpr std::string_view name =
        Leaf == nanoflann_default_leaf ? "nanoflann" : "nanoflann_tuned";

    void build(std::span<const plumbline::Vec<Dim>> points, double radius) {
        plumbline::check_radius(space_, radius);
        plumbline::check_points(space_, points);
        radius_ = radius;
        tree_.reset();
        points_.x.assign(points.begin(), points.end());
        if (!points.empty())
            tree_ = std::make_unique<Tree>(Dim, points_,
                                           nanoflann::KDTreeSingleIndexAdaptorParams(Leaf));
    }
    void find(std::span<const plumbline::Vec<Dim>> queries, plumbline::Radii radii,
              plumbline::NeighbourLists& lists) const {
        plumbline::fill_lists(queries.size(), lists,
                              [&](std::size_t i, std::vector<plumbline::Index>& row) {
                                  gather(queries[i], radii.of(i), row);
                              });
    }
    void find(std::span<const plumbline::Vec<Dim>> queries, plumbline::Radii radii,
              plumbline::PackedLists& lists) const {
        lists.restart(queries.size());
        plumbline::parallel_for_parts(queries.size(), [&](std::size_t first, std::size_t last) {
            plumbline::PackedLists::Writer writer(lists);
            std::vector<plumbline::Index> row;
            for (std::size_t i = first; i < last; ++i) {
                row.clear();
                gather(queries[i], radii.of(i), row);
                std::ranges::copy(row, writer.room(row.size()));
                writer.add(static_cast<plumbline::Index>(i), row.size());
            }
        });
    }

    const plumbline::OpenSpace<Dim>& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t memory() const {
        return points_.x.size() * sizeof(plumbline::Vec<Dim>) +
               (tree_ ? tree_->usedMemory(*tree_) : 0);
    }

private:
    void gather(const plumbline::Vec<Dim>& query, double radius,
                std::vector<plumbline::Index>& row) const {
        if (!tree_) return;
        Row result{radius * radius, row};
        tree_->findNeighbors(result, query.data(), {});
    }

    struct Cloud {
        plumbline::Points<Dim> x;
        std::size_t kdtree_get_point_count() const { return x.size(); }
        double kdtree_get_pt(std::size_t i, std::size_t axis) const {
            return x[i][static_cast<Eigen::Index>(axis)];
        }
        template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
    };
    /// The tree's running bound is rounded otherwise than our distance: it gets some room.
    struct Row {
        double squared_radius;
        std::vector<plumbline::Index>& row;

        double worstDist() const { return squared_radius * (1.0 + 1e-12); }
        bool addPoint(double squared_distance, plumbline::Index j) {
            if (squared_distance < squared_radius) row.push_back(j);
            return true;
        }
        bool full() const { return true; }
        std::size_t size() const { return row.size(); }
    };
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<
        nanoflann::L2_Simple_Adaptor<double, Cloud, double, plumbline::Index>, Cloud, Dim,
        plumbline::Index>;

    plumbline::OpenSpace<Dim> space_;
    double radius_ = 0.0;
    Cloud points_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace benchmarks
