#pragma once

#include "solver/neighbours/neighbour_lists.h"
#include "solver/neighbours/search_input.h"

namespace plumbline {

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
