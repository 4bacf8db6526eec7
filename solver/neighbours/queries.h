#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/neighbour_lists.h"
#include "solver/neighbours/space.h"

#include <atomic>
#include <charconv>
#include <limits>

namespace plumbline {

/// Radii and coordinates whose squares neither overflow nor vanish: up to 1e150 in double, 1e18 in
/// single precision, radii from 1e-150 and 1e-18.
template <class Real> constexpr double largest_length = sizeof(Real) == 8 ? 1e150 : 1e18;
template <class Real> constexpr double smallest_radius = 1.0 / largest_length<Real>;

inline std::string as_text(double x) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

/// Throws InvalidInput unless smallest_radius ≤ radius ≤ largest_length and the space allows it.
template <class Real = double, class Space> void check_radius(const Space& space, double radius) {
    if (!(radius >= smallest_radius<Real> && radius <= largest_length<Real>))
        throw InvalidInput("neighbour search: expected a radius in [" +
                           as_text(smallest_radius<Real>) + ", " + as_text(largest_length<Real>) +
                           "], found " + as_text(radius));
    space.check_radius(radius);
}

/// Throws InvalidInput for a coordinate that is not finite, is above largest_length or outside of the
/// space, and for more points than an Index can number.
template <class Space, class Real, int Dim>
void check_points(const Space& space, std::span<const VecOf<Real, Dim>> points) {
    if (points.size() >= std::numeric_limits<Index>::max())
        throw InvalidInput("neighbour search: expected fewer than 2^32 - 1 points, found " +
                           std::to_string(points.size()));
    constexpr Real largest = static_cast<Real>(largest_length<Real>);
    std::atomic<bool> all_good = true;
    parallel_for_parts(points.size(), [&](std::size_t first, std::size_t last) {
        int good = 1;
        for (std::size_t i = first; i < last; ++i)
            for (int axis = 0; axis < Dim; ++axis)
                good &= std::abs(points[i][axis]) <= largest && space.holds(points[i][axis], axis);
        if (good == 0) all_good = false;
    });
    if (all_good) return;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < Dim; ++axis) {
            const double x = points[i][axis];
            if (!(std::abs(x) <= largest))
                throw InvalidInput("neighbour search: expected a finite coordinate below " +
                                   as_text(largest_length<Real>) + ", found " + as_text(x) +
                                   " (point " + std::to_string(i) + ", axis " +
                                   std::to_string(axis) + ")");
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
/// Search::find(queries, radii, lists), Search::space() and Search::radius(). `Lists` is
/// NeighbourLists, or another form for which the search has a `find`.
template <class Search, int Dim, class Real = double> class Queries {
    using Given = std::span<const VecOf<Real, Dim>>;

public:
    template <class Lists>
    requires(!std::convertible_to<Lists&, std::span<const double>>) void query(Given queries,
                                                                               Lists& lists) const {
        check_points(search().space(), queries);
        search().find(queries, Radii(search().radius()), lists);
    }
    template <class Lists>
    void query(Given queries, std::span<const double> radii, Lists& lists) const {
        check_radii(radii, queries.size());
        check_points(search().space(), queries);
        search().find(queries, Radii(radii), lists);
    }
    NeighbourLists query(Given queries) const {
        NeighbourLists lists;
        query(queries, lists);
        return lists;
    }
    NeighbourLists query(Given queries, std::span<const double> radii) const {
        NeighbourLists lists;
        query(queries, radii, lists);
        return lists;
    }

protected:
    void check_radii(std::span<const double> radii, std::size_t queries) const {
        if (radii.size() != queries)
            throw InvalidInput("neighbour search: expected one radius for each of " +
                               std::to_string(queries) + " queries, found " +
                               std::to_string(radii.size()));
        for (const double radius : radii) check_radius<Real>(search().space(), radius);
    }

private:
    const Search& search() const { return static_cast<const Search&>(*this); }
};

}  // namespace plumbline
