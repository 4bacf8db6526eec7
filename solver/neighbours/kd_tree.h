#pragma once

#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

#include <concepts>
#include <numeric>

namespace plumbline {

/// A kd-tree with packed leaves: built in O(n log n), its lists do not depend on its shape.
/// adams2009 Algs. 1, 2; Sec. 5.1. Other than Algorithm 1 it splits by rank, n/2 points on either side
/// even where coordinates coincide, and along the longest edge of the points' box: erratum 27.
/// Other than Algorithm 2 it tests balls against the boxes of the points, not against half-spaces.
template <int Dim, class Space = OpenSpace<Dim>>
class KdTree : public Queries<KdTree<Dim, Space>, Dim> {
public:
    static constexpr std::string_view name = "kd_tree";

    /// A leaf holds at most `leaf_size` points, unless more of them coincide.
    KdTree() requires std::default_initializable<Space> : KdTree(Space{}) {}
    explicit KdTree(Space space, Index leaf_size = 16) : space_{space}, leaf_size_{leaf_size} {
        if (leaf_size < 1) throw InvalidInput("KdTree: expected a leaf size of 1 or more, found 0");
    }

    void build(std::span<const Vec<Dim>> points, double radius) {
        check_radius(space_, radius);
        check_points(space_, points);
        radius_ = radius;
        order_.resize(points.size());
        std::iota(order_.begin(), order_.end(), Index{0});
        nodes_.clear();
        if (!points.empty()) split(points, 0, static_cast<Index>(points.size()));
        points_.resize(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) points_[k] = points[order_[k]];
    }

    void find(std::span<const Vec<Dim>> queries, Radii radii, NeighbourLists& lists) const {
        fill_lists(queries.size(), lists, [&](std::size_t i, std::vector<Index>& row) {
            const double r = radii.of(i);
            for_each_near_leaf(queries[i], r * r, [&](Index first, Index last) {
                for (Index k = first; k < last; ++k)
                    if (squared_distance(space_, queries[i], points_[k]) < r * r)
                        row.push_back(order_[k]);
            });
        });
    }

    /// Calls leaf(first, last) with the range of each leaf whose box the ball around `x` meets; returns
    /// the number of nodes visited.                                        adams2009 Alg. 2
    template <class Leaf>
    std::size_t for_each_near_leaf(const Vec<Dim>& x, double squared_radius, Leaf leaf) const {
        std::size_t visited = 0;
        for (std::size_t n = 0; n < nodes_.size(); ++visited) {
            const Node& node = nodes_[n];
            const bool near = squared_gap(x, node) < squared_radius;
            if (near && node.is_leaf()) leaf(node.first, node.last);
            n = near ? n + 1 : node.next;
        }
        return visited;
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t nodes() const { return nodes_.size(); }
    std::size_t memory() const {
        return points_.size() * (sizeof(Vec<Dim>) + sizeof(Index)) + nodes_.size() * sizeof(Node);
    }

private:
    /// Nodes are stored in preorder: the first child of n is n + 1, and next is the first node that
    /// is not below n. A leaf has no node below it.
    struct Node {
        Vec<Dim> low, high;
        Index first, last;
        Index next = 0;
        bool leaf = false;
        bool is_leaf() const { return leaf; }
    };

    void split(std::span<const Vec<Dim>> points, Index first, Index last) {
        const std::size_t self = nodes_.size();
        Vec<Dim> low = points[order_[first]], high = low;
        for (Index k = first + 1; k < last; ++k) {
            low = low.cwiseMin(points[order_[k]]);
            high = high.cwiseMax(points[order_[k]]);
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const bool leaf = last - first <= leaf_size_ || low[axis] == high[axis];
        nodes_.push_back({low, high, first, last, 0, leaf});
        if (!leaf) {
            const Index middle = first + (last - first) / 2;
            std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                             [&](Index a, Index b) { return points[a][axis] < points[b][axis]; });
            split(points, first, middle);
            split(points, middle, last);
        }
        nodes_[self].next = static_cast<Index>(nodes_.size());
    }

    /// Summed like squared_distance: each term is rounded monotonically, so no point in the box has a
    /// smaller squared distance.
    double squared_gap(const Vec<Dim>& x, const Node& node) const {
        double total = 0.0;
        for (int axis = 0; axis < Dim; ++axis) {
            const double g = space_.gap(x[axis], node.low[axis], node.high[axis], axis);
            total += g * g;
        }
        return total;
    }

    Space space_;
    Index leaf_size_;
    double radius_ = 0.0;
    Points<Dim> points_;        // in the order of the leaves
    std::vector<Index> order_;  // points_[k] was given as point order_[k]
    std::vector<Node> nodes_;
};

}  // namespace plumbline
