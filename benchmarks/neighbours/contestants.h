#pragma once

#include "solver/neighbours/neighbour_lists.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace benchmarks {

/// A search chosen at run time. A call costs nothing beside building or querying a whole cloud.
template <int Dim> class Contestant {
public:
    using Points = std::span<const plumbline::Vec<Dim>>;
    using Lists = plumbline::NeighbourLists;

    virtual ~Contestant() = default;
    /// The points of the next calls, in the form that the search takes; not timed.
    virtual void take(Points points) { points_ = points; }
    virtual void build(double radius) = 0;
    /// The points that were taken are those of `build`, moved: by the search's own update if it has one, else
    /// by building.
    virtual void update() = 0;
    virtual bool has_update() const { return false; }
    /// The neighbours of all points; `radii` has one radius for each, or is empty: that of `build` for
    /// all. They are in `lists`, or in a form of the search's own.
    virtual void query(std::span<const double> radii, Lists& lists) = 0;
    /// The neighbours that the last query found, as lists, and the memory that they took.
    virtual Lists answer(const Lists& lists) const { return lists; }
    virtual std::size_t answer_bytes(const Lists& lists) const {
        return lists.indices.size() * sizeof(plumbline::Index) +
               lists.offsets.size() * sizeof(std::size_t);
    }

    /// What the answer is: "sorted lists", "lists as found", …
    virtual std::string form() const { return "sorted lists"; }
    /// Whether the answer is all neighbours in double precision, so that a ranking means something.
    virtual bool is_full_answer() const { return true; }
    virtual bool is_single_precision() const { return false; }
    virtual bool has_own_radii() const { return true; }

protected:
    Points points() const { return points_; }

private:
    Points points_;
};

/// The searches of the solver but brute force, then the libraries. A new one is added to the list in
/// our_contestants.cpp or library_contestants.cpp.
std::vector<std::string> contestant_names();

/// Throws InvalidInput, naming those there are, if there is none of that name; Dim is 2 or 3.
template <int Dim> std::unique_ptr<Contestant<Dim>> make_contestant(const std::string& name);

/// A name and how to make what has it.
template <int Dim> struct ContestantMaker {
    std::string name;
    std::function<std::unique_ptr<Contestant<Dim>>()> make;
};
template <int Dim> std::vector<ContestantMaker<Dim>> our_contestants();
template <int Dim> std::vector<ContestantMaker<Dim>> library_contestants();

}  // namespace benchmarks
