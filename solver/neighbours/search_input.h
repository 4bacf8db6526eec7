#pragma once

#include "solver/neighbours/space.h"

#include <limits>
#include <span>

namespace plumbline {

/// Radii and coordinates whose squares neither overflow nor vanish.
inline constexpr double largest_length = 1e150, smallest_radius = 1e-150;

inline std::string as_text(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}

/// Throws InvalidInput unless smallest_radius ≤ radius ≤ largest_length and the space allows it.
template <class Space> void check_radius(const Space& space, double radius) {
    if (!(radius >= smallest_radius && radius <= largest_length))
        throw InvalidInput("neighbour search: expected a radius in [1e-150, 1e150], found " +
                           as_text(radius));
    space.check_radius(radius);
}

/// Throws InvalidInput for a coordinate that is not finite, is above largest_length or outside of the
/// space, and for more points than an Index can number.
template <class Space, int Dim>
void check_points(const Space& space, std::span<const Vec<Dim>> points) {
    if (points.size() >= std::numeric_limits<Index>::max())
        throw InvalidInput("neighbour search: expected fewer than 2^32 - 1 points, found " +
                           std::to_string(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < Dim; ++axis) {
            const double x = points[i][axis];
            if (!(std::abs(x) <= largest_length))
                throw InvalidInput(
                    "neighbour search: expected a finite coordinate below 1e150, found " +
                    as_text(x) + " (point " + std::to_string(i) + ", axis " + std::to_string(axis) +
                    ")");
            space.check_coordinate(x, axis);
        }
}

}  // namespace plumbline
