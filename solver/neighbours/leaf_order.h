#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/candidates.h"

#include <span>

namespace plumbline {

/// Points in the order of the leaves of a kd-tree split by rank along the longest edge of their box, as
/// in kd_tree.h, with one array per coordinate; leaves are treated as groups.
template <int Dim, class Real> class LeafOrder {
    using Point = VecOf<Real, Dim>;
    using Given = std::span<const Point>;

public:
    /// Nodes are stored in preorder: the first child of node n is n + 1, and `next` is the first node that
    /// is not below it.
    struct Node {
        Point low, high;
        Index first, last;  // its points
        Index next = 0;
        bool leaf = false;
    };

    void sort(Given points, Index leaf_size) {
        records_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            records_[i] = {points[i], static_cast<Index>(i)};
        nodes_.clear();
        leaves_.clear();
        if (!points.empty()) split(0, static_cast<Index>(points.size()), leaf_size);
        constexpr std::size_t room_beyond = candidates_per_step;
        order_.resize(points.size() + room_beyond);
        for (int axis = 0; axis < Dim; ++axis) x_[axis].resize(points.size() + room_beyond);
        for (std::size_t k = 0; k < points.size(); ++k) {
            order_[k] = records_[k].number;
            for (int axis = 0; axis < Dim; ++axis) x_[axis][k] = records_[k].x[axis];
        }
    }
    bool holds(Given points) const {
        if (points.size() != size()) return false;
        for (const Record& record : records_)
            if (points[record.number] != record.x) return false;
        return true;
    }

    std::size_t size() const { return records_.size(); }
    Index order(std::size_t k) const { return order_[k]; }
    const Index* order() const { return order_.data(); }
    const Point& position(std::size_t k) const { return records_[k].x; }
    const Real* x(int axis) const { return x_[axis].data(); }

    const std::vector<Node>& nodes() const { return nodes_; }
    std::size_t leaves() const { return leaves_.size(); }
    const Node& leaf(std::size_t l) const { return nodes_[leaves_[l]]; }
    /// Leaves are treated in parallel in blocks of so many.
    static constexpr std::size_t leaves_per_block = 32;
    std::size_t blocks() const { return (leaves() + leaves_per_block - 1) / leaves_per_block; }

    std::size_t memory() const {
        const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
        std::size_t all = bytes(records_) + bytes(nodes_) + bytes(leaves_) + bytes(order_);
        for (const auto& coordinate : x_) all += bytes(coordinate);
        return all;
    }

private:
    struct Record {
        Point x;
        Index number;
    };

    void split(Index first, Index last, Index leaf_size) {
        const std::size_t self = nodes_.size();
        Point low = records_[first].x, high = low;
        for (Index k = first + 1; k < last; ++k) {
            low = low.cwiseMin(records_[k].x);
            high = high.cwiseMax(records_[k].x);
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const bool leaf = last - first <= leaf_size;
        nodes_.push_back({low, high, first, last, 0, leaf});
        if (leaf) {
            leaves_.push_back(static_cast<Index>(self));
        } else {
            const Index middle = first + (last - first) / 2;
            std::nth_element(
                records_.begin() + first, records_.begin() + middle, records_.begin() + last,
                [axis](const Record& a, const Record& b) { return a.x[axis] < b.x[axis]; });
            split(first, middle, leaf_size);
            split(middle, last, leaf_size);
        }
        nodes_[self].next = static_cast<Index>(nodes_.size());
    }

    std::vector<Record> records_;
    std::vector<Index> order_;  // point k in this order was given as order_[k]
    std::array<std::vector<Real>, Dim> x_;
    std::vector<Node> nodes_;
    std::vector<Index> leaves_;
};

}  // namespace plumbline
