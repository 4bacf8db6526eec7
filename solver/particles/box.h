#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <cmath>
#include <limits>
#include <string>

namespace plumbline {

/// An axis-aligned box, closed below and open above: x is inside iff low ≤ x < high on every axis.
template <int Dim> struct Box {
    Vec<Dim> low, high;  // [m]

    Vec<Dim> size() const { return high - low; }
    double volume() const { return size().prod(); }  // [m^Dim]
    bool contains(const Vec<Dim>& x) const {
        return (x.array() >= low.array()).all() && (x.array() < high.array()).all();
    }
    /// The point at the fractions `u`, each in [0, 1), of the edges; inside, whatever the rounding.
    Vec<Dim> at(const Vec<Dim>& u) const {
        Vec<Dim> x = low + u.cwiseProduct(size());
        for (int d = 0; d < Dim; ++d)
            if (x[d] >= high[d]) x[d] = std::nextafter(high[d], low[d]);
        return x;
    }
};

/// [0, 1)^Dim.
template <int Dim> Box<Dim> unit_box() { return {Vec<Dim>::Zero(), Vec<Dim>::Ones()}; }

/// Throws InvalidInput unless every edge is finite and longer than 0.
template <int Dim> void require_proper(const Box<Dim>& box) {
    for (int d = 0; d < Dim; ++d)
        if (!(box.high[d] > box.low[d]) || !std::isfinite(box.high[d] - box.low[d]))
            throw InvalidInput("box: expected low < high, finite, on axis " + std::to_string(d) +
                               ", found [" + std::to_string(box.low[d]) + ", " +
                               std::to_string(box.high[d]) + ")");
}

/// Throws InvalidInput, naming the quantity, unless it is finite and positive.
inline void require_positive(double value, const std::string& name) {
    if (!(value > 0.0) || !std::isfinite(value))
        throw InvalidInput(name + ": expected a finite number > 0, found " + std::to_string(value));
}

/// Throws InvalidInput unless at least 1 and few enough for an Index to tell them apart.
inline Index require_count(double n) {
    constexpr double most = std::numeric_limits<Index>::max() - 1.0;
    if (!(n >= 1.0 && n <= most))
        throw InvalidInput("number of points: expected 1 to 4294967294, found " +
                           std::to_string(n));
    return static_cast<Index>(n);
}

}  // namespace plumbline
