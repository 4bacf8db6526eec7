#pragma once

#include "solver/neighbours/grouped_search.h"
#include "solver/neighbours/leaf_order.h"

#include <concepts>

namespace plumbline {

/// The kd-tree for radii or densities that vary strongly (adams2009 Sec. 5.3): the queries of a leaf share
/// one gathered set of candidates, the points of all leaves whose boxes come closer to its box than the
/// largest radius of its queries. Where KdTree (adams2009 Algs. 1, 2) descends for each query, this one
/// descends for each leaf, and its boxes are as wide as the points are apart wherever they are.
///
/// The order of its PackedLists is that of the leaves, from left to right.
template <int Dim, class Space = OpenSpace<Dim>, class Real = double>
class LeafTree
    : public GroupedSearch<LeafTree<Dim, Space, Real>, LeafOrder<Dim, Real>, Dim, Space, Real> {
    using Given = std::span<const VecOf<Real, Dim>>;
    using Order = LeafOrder<Dim, Real>;
    using Base = GroupedSearch<LeafTree, Order, Dim, Space, Real>;
    friend Base;

public:
    static constexpr std::string_view name = "leaf_tree";

    LeafTree() requires std::default_initializable<Space> : LeafTree(Space{}) {}
    explicit LeafTree(Space space, Index leaf_size = 24,
                      Instructions instructions = best_instructions())
        : Base{space, instructions}, leaf_size_{leaf_size} {
        if (leaf_size < 1) throw InvalidInput("LeafTree: expected a leaf size above 0, found 0");
    }

    void build(Given points, double radius) {
        this->check(points, radius);
        points_.sort(points, leaf_size_);
    }
    std::size_t memory() const { return points_.memory(); }

private:
    using Base::space_;
    using Node = typename Order::Node;
    struct Run {
        Index first, last;
    };

    const Order& points() const { return points_; }
    Order sorted(Given queries) const {
        Order order;
        order.sort(queries, leaf_size_);
        return order;
    }

    template <class Visit>
    void visit_block(std::size_t block, const Order& queries, Radii radii, Part part,
                     Visit& visit) const {
        const std::size_t begin = block * Order::leaves_per_block;
        const std::size_t end = std::min(queries.leaves(), begin + Order::leaves_per_block);
        Candidates<Dim, Real> near;
        std::vector<Run> runs;
        for (std::size_t l = begin; l < end; ++l) {
            const Node& leaf = queries.leaf(l);
            const auto group = Base::group_of(queries, leaf.first, leaf.last, radii);
            find_runs(leaf, static_cast<Real>(group.radius), part == Part::later ? leaf.first : 0,
                      runs);
            gather(runs, near);
            this->visit_group(group, queries, radii, part, near, visit);
        }
    }

    /// The points from `from` on in the leaves that may hold neighbours of the queries of `leaf`.
    void find_runs(const Node& leaf, Real radius, Index from, std::vector<Run>& runs) const {
        runs.clear();
        const auto& nodes = points_.nodes();
        for (std::size_t n = 0; n < nodes.size();) {
            const Node& node = nodes[n];
            if (node.last <= from || !(squared_gap(leaf, node) < radius * radius)) {
                n = node.next;
                continue;
            }
            ++n;
            if (!node.leaf) continue;
            const Index first = std::max(node.first, from);
            if (!runs.empty() && runs.back().last == first)
                runs.back().last = node.last;
            else
                runs.push_back({first, node.last});
        }
    }
    /// Summed like squared_distance: each term is rounded monotonically, so no two points in the boxes
    /// have a smaller squared distance.
    Real squared_gap(const Node& a, const Node& b) const {
        Real total = 0;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real g = space_.gap(a.low[axis], a.high[axis], b.low[axis], b.high[axis], axis);
            total += g * g;
        }
        return total;
    }
    void gather(const std::vector<Run>& runs, Candidates<Dim, Real>& near) const {
        std::size_t size = 0;
        for (const Run& run : runs) size += run.last - run.first;
        near.resize(size);
        std::size_t to = 0;
        for (const Run& run : runs) {
            const std::size_t n = run.last - run.first;
            for (int axis = 0; axis < Dim; ++axis)
                std::copy_n(points_.x(axis) + run.first, n, near.x(axis) + to);
            std::copy_n(points_.order() + run.first, n, near.id() + to);
            to += n;
        }
        near.close();
    }
    Index leaf_size_;
    Order points_;
};

}  // namespace plumbline
