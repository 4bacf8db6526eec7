#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <concepts>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline {

/// Neighbours of n queries in compressed rows: row i is indices[offsets[i] .. offsets[i + 1]).
/// For every search alike: j is listed iff ‖queryᵢ − xⱼ‖ < radius as squared_distance (space.h)
/// computes it, so a query that is a point lists itself; once; in ascending order. Hence two searches
/// agree iff their lists are equal.                                   adams2009 Sec. 5, N_r(x)
struct NeighbourLists {
    std::vector<std::size_t> offsets;  // n + 1
    std::vector<Index> indices;        // offsets[n]

    std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
    std::span<const Index> of(Index i) const {
        return {indices.data() + offsets[i], indices.data() + offsets[i + 1]};
    }
    bool operator==(const NeighbourLists&) const = default;
};

/// Build once, query often; both steps are timed apart. `build` copies what it needs from `points`;
/// `query` is const and may be called from several threads at once. All lengths in one unit.
/// `query(queries, lists)` reuses the memory of `lists`, which is several times faster than new memory.
/// All throw InvalidInput for a coordinate that is not finite and for a radius that is not positive.
template <class S, int Dim>
concept NeighbourSearch = requires(S s, const S built, std::span<const Vec<Dim>> points,
                                   double radius, NeighbourLists& lists) {
    { S::name } -> std::convertible_to<std::string_view>;
    { s.build(points, radius) } -> std::same_as<void>;
    { built.query(points) } -> std::same_as<NeighbourLists>;
    { built.query(points, lists) } -> std::same_as<void>;
    { built.memory() } -> std::same_as<std::size_t>;  // bytes held between queries
};

/// A search that also answers with a radius of its own for each query: j is listed in row i iff
/// ‖queryᵢ − xⱼ‖ < radiiᵢ. The relation is symmetric only if all radii are equal. The radius given to
/// `build` is then a size typical of the radii: the lists do not depend on it, the time does.
template <class S, int Dim>
concept VariableRadiusSearch = NeighbourSearch<S, Dim> &&
    requires(const S built, std::span<const Vec<Dim>> points, std::span<const double> radii,
             NeighbourLists& lists) {
    { built.query(points, radii) } -> std::same_as<NeighbourLists>;
    { built.query(points, radii, lists) } -> std::same_as<void>;
};

}  // namespace plumbline
