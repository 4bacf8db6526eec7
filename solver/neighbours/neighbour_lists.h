#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <concepts>
#include <span>
#include <vector>

namespace plumbline {

/// Neighbours of n queries in compressed rows: row i is indices[offsets[i] .. offsets[i + 1]).
/// For every search alike: j is listed iff ‖queryᵢ − xⱼ‖ < radius, so a query that is a point
/// lists itself; once; in ascending order. Hence two searches agree iff their lists are equal.
struct NeighbourLists {
    std::vector<std::size_t> offsets;  // n + 1
    std::vector<Index> indices;        // offsets[n]

    std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
    std::span<const Index> of(Index i) const {
        return {indices.data() + offsets[i], indices.data() + offsets[i + 1]};
    }
    bool operator==(const NeighbourLists&) const = default;
};

/// Build once, query often; both steps are timed apart. `build` copies what it needs from `points`.
template <class S, int Dim>
concept NeighbourSearch = requires(S s, const S built, std::span<const Vec<Dim>> points,
                                   double radius) {
    { S::name } -> std::convertible_to<std::string_view>;
    { s.build(points, radius) } -> std::same_as<void>;
    { built.query(points) } -> std::same_as<NeighbourLists>;
};

}  // namespace plumbline
