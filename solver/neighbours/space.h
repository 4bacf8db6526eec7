#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace plumbline {

/// Where points live: how far apart two coordinates are. A search is a template over it.
/// `difference` is the signed distance along one axis; `gap` the smallest |difference| between x and
/// any coordinate in [low, high]. Rounding is monotonic, so the computed gap never exceeds the computed
/// |difference|: a search that discards a box by its gap discards no neighbour.
template <int Dim> struct OpenSpace {
    static constexpr bool is_periodic = false;

    double difference(double a, double b, int) const { return a - b; }
    double gap(double x, double low, double high, int) const {
        return std::max({low - x, x - high, 0.0});
    }
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

    double difference(double a, double b, int axis) const {
        const double d = a - b, edge = edge_[axis];
        return d > 0.5 * edge ? d - edge : d < -0.5 * edge ? d + edge : d;
    }
    double gap(double x, double low, double high, int axis) const {
        const double direct = std::max({low - x, x - high, 0.0});
        const double farthest = std::max(std::abs(x - low), std::abs(x - high));
        return std::min(direct, std::max(edge_[axis] - farthest, 0.0));
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
    /// Throws InvalidInput for a coordinate outside of the box.
    void check_coordinate(double x, int axis) const {
        if (!(low_[axis] <= x && x <= high_[axis]))
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
template <class Space, int Dim>
double squared_distance(const Space& space, const Vec<Dim>& a, const Vec<Dim>& b) {
    const double first = space.difference(a[0], b[0], 0);
    double total = first * first;
    for (int axis = 1; axis < Dim; ++axis) {
        const double d = space.difference(a[axis], b[axis], axis);
        total += d * d;
    }
    return total;
}

}  // namespace plumbline
