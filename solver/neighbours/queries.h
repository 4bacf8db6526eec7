#pragma once

#include "solver/neighbours/neighbour_lists.h"
#include "solver/neighbours/space.h"

#include <cstdio>
#include <limits>

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

/// The radius of each query: one for all, or one of its own.
class Radii {
public:
    explicit Radii(double radius) : common_{radius} {}
    explicit Radii(std::span<const double> radii) : own_{radii}, vary_{true} {}

    double of(std::size_t i) const { return vary_ ? own_[i] : common_; }
    bool vary() const { return vary_; }

private:
    double common_ = 0.0;
    std::span<const double> own_;
    bool vary_ = false;
};

/// The queries that every search offers (see NeighbourSearch and VariableRadiusSearch), all from
/// Search::find(queries, radii, lists), Search::space() and Search::radius().
template <class Search, int Dim> class Queries {
public:
    void query(std::span<const Vec<Dim>> queries, NeighbourLists& lists) const {
        check_points(search().space(), queries);
        search().find(queries, Radii(search().radius()), lists);
    }
    void query(std::span<const Vec<Dim>> queries, std::span<const double> radii,
               NeighbourLists& lists) const {
        if (radii.size() != queries.size())
            throw InvalidInput("neighbour search: expected one radius for each of " +
                               std::to_string(queries.size()) + " queries, found " +
                               std::to_string(radii.size()));
        check_points(search().space(), queries);
        for (const double radius : radii) check_radius(search().space(), radius);
        search().find(queries, Radii(radii), lists);
    }
    NeighbourLists query(std::span<const Vec<Dim>> queries) const {
        NeighbourLists lists;
        query(queries, lists);
        return lists;
    }
    NeighbourLists query(std::span<const Vec<Dim>> queries, std::span<const double> radii) const {
        NeighbourLists lists;
        query(queries, radii, lists);
        return lists;
    }

private:
    const Search& search() const { return static_cast<const Search&>(*this); }
};

}  // namespace plumbline
