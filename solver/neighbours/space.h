#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace plumbline {

/// A point in the precision in which distances are decided.
template <class Real, int Dim> using VecOf = Eigen::Matrix<Real, Dim, 1>;

/// Where points live: how far apart two coordinates are. A search is a template over it.
/// `difference` is the signed distance along one axis; `gap` the smallest |difference| between x and
/// any coordinate in [low, high]. Rounding is monotonic, so the computed gap never exceeds the computed
/// |difference|: a search that discards a box by its gap discards no neighbour.
template <int Dim> struct OpenSpace {
    static constexpr bool is_periodic = false;

    template <class Real> Real difference(Real a, Real b, int) const { return a - b; }
    double gap(double x, double low, double high, int) const {
        return std::max({low - x, x - high, 0.0});
    }
    /// The smallest |difference| of any two coordinates in [low, high] and in [other_low, other_high].
    template <class Real>
    Real gap(Real low, Real high, Real other_low, Real other_high, int) const {
        return std::max({other_low - high, low - other_high, Real(0)});
    }
    bool holds(double, int) const { return true; }
    void check_coordinate(double, int) const {}
    void check_radius(double) const {}
};

/// A box repeated without end along every axis; the distance of two points is that of their nearest
/// images. Points lie in the box, faces included; the radius is less than half of every edge, so that
/// of the images of a point at most one is a neighbour.
template <int Dim> class PeriodicBox {
public:
    static constexpr bool is_periodic = true;

    /// Throws InvalidInput unless low < high along every axis.
    PeriodicBox(const Vec<Dim>& low, const Vec<Dim>& high) : low_{low}, high_{high} {
        edge_ = high - low;
        for (int axis = 0; axis < Dim; ++axis)
            if (!(edge_[axis] > 0.0 && std::isfinite(edge_[axis])))
                throw InvalidInput(
                    "PeriodicBox: expected low < high, found " + std::to_string(low[axis]) +
                    " and " + std::to_string(high[axis]) + " along axis " + std::to_string(axis));
    }

    const Vec<Dim>& low() const { return low_; }
    const Vec<Dim>& high() const { return high_; }
    const Vec<Dim>& edge() const { return edge_; }

    template <class Real> Real difference(Real a, Real b, int axis) const {
        const Real d = a - b, edge = static_cast<Real>(edge_[axis]), half = Real(0.5) * edge;
        return d > half ? d - edge : d < -half ? d + edge : d;
    }
    double gap(double x, double low, double high, int axis) const {
        const double direct = std::max({low - x, x - high, 0.0});
        const double farthest = std::max(std::abs(x - low), std::abs(x - high));
        return std::min(direct, std::max(edge_[axis] - farthest, 0.0));
    }
    template <class Real>
    Real gap(Real low, Real high, Real other_low, Real other_high, int axis) const {
        const Real direct = std::max({other_low - high, low - other_high, Real(0)});
        const Real farthest = std::max(high - other_low, other_high - low);
        return std::min(direct, std::max(static_cast<Real>(edge_[axis]) - farthest, Real(0)));
    }
    /// The image of x inside the box.
    Vec<Dim> wrap(const Vec<Dim>& x) const {
        Vec<Dim> image;
        for (int axis = 0; axis < Dim; ++axis) {
            const double turns = std::floor((x[axis] - low_[axis]) / edge_[axis]);
            image[axis] = std::clamp(x[axis] - turns * edge_[axis], low_[axis], high_[axis]);
        }
        return image;
    }
    bool holds(double x, int axis) const { return low_[axis] <= x && x <= high_[axis]; }
    /// Throws InvalidInput for a coordinate outside of the box.
    void check_coordinate(double x, int axis) const {
        if (!holds(x, axis))
            throw InvalidInput("expected a coordinate inside the periodic box [" +
                               std::to_string(low_[axis]) + ", " + std::to_string(high_[axis]) +
                               "] (PeriodicBox::wrap moves it there), found " + std::to_string(x));
    }
    /// Throws InvalidInput unless radius < edge / 2.
    void check_radius(double radius) const {
        if (!(radius < 0.5 * edge_.minCoeff()))
            throw InvalidInput("expected a radius below half of the periodic box, " +
                               std::to_string(0.5 * edge_.minCoeff()) + ", found " +
                               std::to_string(radius));
    }

private:
    Vec<Dim> low_, high_, edge_;
};

/// ‖a − b‖², summed in the order of the axes. This one expression decides in every search who is a
/// neighbour: squared_distance < radius · radius. Its Dim + 3 roundings decide rightly unless
/// |‖a − b‖ / radius − 1| < (Dim + 4) 2⁻⁵⁴ (4e-16 in space); where differences and squares are exact, as on a
/// lattice of small multiples of a power of two, ties at exactly the radius are decided rightly too.
/// In a periodic box the first rounding is of the box: add Dim 2⁻⁵³ edge / radius.
/// In single precision positions, radius and edges are given in it, all is computed in it, and the
/// powers of two are 2⁻²⁵ and 2⁻²⁴.
template <class Space, class Real, int Dim>
Real squared_distance(const Space& space, const VecOf<Real, Dim>& a, const VecOf<Real, Dim>& b) {
    const Real first = space.difference(a[0], b[0], 0);
    Real total = first * first;
    for (int axis = 1; axis < Dim; ++axis) {
        const Real d = space.difference(a[axis], b[axis], axis);
        total += d * d;
    }
    return total;
}

}  // namespace plumbline
