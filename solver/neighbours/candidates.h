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
    using Point = VecOf<Real, Dim>;

public:
    /// Copies may run over the end of what they copy by so many elements.
    static constexpr std::size_t slack = candidates_per_step;

    /// Makes room for n candidates; their arrays are then to be filled, and closed.
    void resize(std::size_t n) {
        size_ = n;
        is_rounded_ = false;
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

    /// Keeps those that may be closer than the root of squared_radius to a point of the box low .. high,
    /// in their order.
    template <class Space>
    void keep_near(const NearFunctions<Real>& functions, const Space& space, const Point& low,
                   const Point& high, Real squared_radius) {
        BoxTest<Real> test{};
        test.id = id();
        test.size = size_;
        test.squared_radius = squared_radius;
        for (int axis = 0; axis < Dim; ++axis) {
            test.x[axis] = x(axis);
            test.low[axis] = low[axis];
            test.high[axis] = high[axis];
            if constexpr (Space::is_periodic)
                test.edge[axis] = static_cast<Real>(space.edge()[axis]);
        }
        size_ = functions.keep(test);
        is_rounded_ = false;
        close();
    }

    /// Prepares the test in single precision (RoundedTest) for queries in the box low .. high; until the
    /// candidates are others.
    void round(const Point& low, const Point& high) {
        extent_ = (high - low).maxCoeff();
        origin_ = low;
        const std::size_t n = size_ + slack;
        for (int axis = 0; axis < Dim; ++axis) {
            if (rounded_[axis].size() < n) rounded_[axis].resize(id_.size());
            const Real* from = x(axis);
            float* to = rounded_[axis].data();
            for (std::size_t k = 0; k < n; ++k) to[k] = static_cast<float>(from[k] - origin_[axis]);
        }
        is_rounded_ = true;
    }

    /// Of the candidates from `from` on, those closer to q than the root of squared_radius.
    template <class Space>
    NearTest<Real> near(const Space& space, const Point& q, Real squared_radius,
                        std::size_t from = 0) const {
        NearTest<Real> test;
        test.rounded.x[0] = nullptr;
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
        if (is_rounded_) add_rounded(test);
        return test;
    }

private:
    /// With u = 2^-24, the extent E of the box and a candidate within 2 r of the query: q - origin and
    /// x - origin, at most E and 2 r + E, are rounded by u of that, their difference by u 2 r more along
    /// each axis, so by at most sqrt(3) u (4 r + 2 E) together; squares and sum by 3 u of the squared
    /// distance, so 1.5 u of the distance. All in all by less than 12 u (r + E), of which double precision
    /// has no share to speak of; the margin is 16 u (r + E). Candidates beyond 2 r are told rightly as long
    /// as E < 10^4 r. Within the limits set for r no square of single precision overflows or vanishes.
    void add_rounded(NearTest<Real>& test) const {
        const double r = std::sqrt(static_cast<double>(test.squared_radius));
        if (!(r > 1e-15 && r < 1e15 && extent_ < 1e4 * r)) return;
        const double margin = 0x1p-20 * (r + extent_), least = std::max(r - margin, 0.0);
        constexpr double to_single = 0x1p-23;  // more than what the conversion of a square rounds
        test.rounded.near = static_cast<float>(least * least * (1.0 - to_single));
        test.rounded.perhaps = static_cast<float>((r + margin) * (r + margin) * (1.0 + to_single));
        for (int axis = 0; axis < Dim; ++axis) {
            test.rounded.x[axis] = rounded_[axis].data();
            test.rounded.centre[axis] = static_cast<float>(test.centre[axis] - origin_[axis]);
        }
    }

    template <class T> using Aligned = std::vector<T, Eigen::aligned_allocator<T>>;
    std::array<Aligned<Real>, Dim> x_;
    Aligned<Index> id_;
    std::size_t size_ = 0;
    bool is_rounded_ = false;
    std::array<Aligned<float>, Dim> rounded_;  // coordinates from origin_
    Point origin_ = Point::Zero();
    double extent_ = 0.0;
};

}  // namespace plumbline
