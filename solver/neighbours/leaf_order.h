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

    /// Where a node is stored follows from the numbers of points alone, so all nodes of a depth are split
    /// at once, in parallel, with the same result for any number of threads.
    void sort(Given points, Index leaf_size) {
        const std::size_t n = points.size();
        records_.resize(n);
        parallel_for(n, [&](std::size_t i) { records_[i] = {points[i], static_cast<Index>(i)}; });
        leaf_size_ = leaf_size;
        const Size size = n == 0 ? Size{0, 0} : size_of(static_cast<Index>(n));
        nodes_.resize(size.nodes);
        leaves_.resize(size.leaves);
        split_all({0, static_cast<Index>(n), {0, 0}, size});
        constexpr std::size_t room_beyond = candidates_per_step;
        order_.resize(n + room_beyond);
        for (int axis = 0; axis < Dim; ++axis) x_[axis].resize(n + room_beyond);
        parallel_for(n, [&](std::size_t k) {
            order_[k] = records_[k].number;
            for (int axis = 0; axis < Dim; ++axis) x_[axis][k] = records_[k].x[axis];
        });
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

    /// How many nodes and leaves there are.
    struct Size {
        std::size_t nodes, leaves;
    };
    /// Those of a tree of n points.
    Size size_of(Index n) const {
        if (n <= leaf_size_) return {1, 1};
        const Size left = size_of(n / 2);
        const Size right = n % 2 == 0 ? left : size_of(n - n / 2);
        return {1 + left.nodes + right.nodes, left.leaves + right.leaves};
    }

    /// Points whose tree begins behind so many nodes and leaves, and has that size.
    struct Part {
        Index first, last;
        Size at, size;
    };
    void split_all(const Part& all) {
        constexpr std::size_t enough_parts = 64, worth_threads = 1u << 14;
        if (all.first == all.last) return;
        if (all.last - all.first < worth_threads) return split_below(all);
        std::vector<Part> parts{all};
        while (!parts.empty() && parts.size() < enough_parts) {
            std::vector<Part> below(2 * parts.size());
            parallel_for(
                parts.size(),
                [&](std::size_t k) { split(parts[k], below[2 * k], below[2 * k + 1]); }, 1);
            std::erase_if(below, [](const Part& part) { return part.first == part.last; });
            parts.swap(below);
        }
        parallel_for(
            parts.size(), [&](std::size_t k) { split_below(parts[k]); }, 1);
    }
    void split_below(const Part& part) {
        Part left{}, right{};
        split(part, left, right);
        if (left.first == left.last) return;
        split_below(left);
        split_below(right);
    }
    /// Makes the node of a part, and those below it unless it is a leaf.
    void split(const Part& part, Part& left, Part& right) {
        const auto [first, last, at, size] = part;
        Point low = records_[first].x, high = low;
        for (Index k = first + 1; k < last; ++k) {
            low = low.cwiseMin(records_[k].x);
            high = high.cwiseMax(records_[k].x);
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const bool leaf = last - first <= leaf_size_;
        const auto next = static_cast<Index>(at.nodes + size.nodes);
        nodes_[at.nodes] = {low, high, first, last, next, leaf};
        if (leaf) {
            leaves_[at.leaves] = static_cast<Index>(at.nodes);
            return;
        }
        const Index middle = first + (last - first) / 2;
        std::nth_element(
            records_.begin() + first, records_.begin() + middle, records_.begin() + last,
            [axis](const Record& a, const Record& b) { return a.x[axis] < b.x[axis]; });
        const Size of_left = size_of(middle - first);
        const Size of_right{size.nodes - 1 - of_left.nodes, size.leaves - of_left.leaves};
        left = {first, middle, {at.nodes + 1, at.leaves}, of_left};
        right = {
            middle, last, {left.at.nodes + of_left.nodes, at.leaves + of_left.leaves}, of_right};
    }

    Index leaf_size_ = 1;
    std::vector<Record> records_;
    std::vector<Index> order_;  // point k in this order was given as order_[k]
    std::array<std::vector<Real>, Dim> x_;
    std::vector<Node> nodes_;
    std::vector<Index> leaves_;
};

}  // namespace plumbline
