#pragma once

#include "solver/neighbours/near_points.h"
#include "solver/neighbours/space.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace plumbline {

/// Points that may be neighbours of several queries, one array per coordinate, ready for the distance
/// test of near_points.h. The arrays only grow.
template <int Dim, class Real = double> class Candidates {
public:
    /// Copies may run over the end of what they copy by so many elements.
    static constexpr std::size_t slack = candidates_per_step;

    /// Makes room for n candidates; their arrays are then to be filled, and closed.
    void resize(std::size_t n) {
        size_ = n;
        if (n + 2 * slack <= id_.size()) return;
        for (auto& coordinate : x_) coordinate.resize(2 * (n + slack));
        id_.resize(2 * (n + slack));
    }
    /// Puts candidates at infinity behind the last one, for the rest of its step.
    void close() {
        for (auto& coordinate : x_)
            std::fill_n(coordinate.data() + size_, slack, std::numeric_limits<Real>::infinity());
    }
    std::size_t size() const { return size_; }

    Real* x(int axis) { return x_[axis].data(); }
    const Real* x(int axis) const { return x_[axis].data(); }
    Index* id() { return id_.data(); }
    const Index* id() const { return id_.data(); }

    /// Of the candidates from `from` on, those closer to q than the root of squared_radius.
    template <class Space>
    NearTest<Real> near(const Space& space, const VecOf<Real, Dim>& q, Real squared_radius,
                        std::size_t from = 0) const {
        NearTest<Real> test{};
        test.id = id();
        test.from = from;
        test.size = size_;
        test.squared_radius = squared_radius;
        for (int axis = 0; axis < Dim; ++axis) {
            test.x[axis] = x(axis);
            test.centre[axis] = q[axis];
            if constexpr (Space::is_periodic)
                test.edge[axis] = static_cast<Real>(space.edge()[axis]);
        }
        return test;
    }

private:
    template <class T> using Aligned = std::vector<T, Eigen::aligned_allocator<T>>;
    std::array<Aligned<Real>, Dim> x_;
    Aligned<Index> id_;
    std::size_t size_ = 0;
};

}  // namespace plumbline
