#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/neighbour_lists.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

namespace plumbline {

/// How far beyond its end a list given to sort_ascending must be readable.
inline constexpr std::size_t room_to_sort = 32;

/// Writes the n distinct numbers of `from` to `to`, ascending. Neighbour lists are short: up to
/// `short_list` the place of each number is the count of those below it, for `room_to_sort` numbers at
/// a time in vector registers, without a branch that depends on them.
inline void sort_ascending(const Index* from, std::size_t n, Index* to) {
    constexpr std::size_t short_list = 512, lanes = 8, vectors = room_to_sort / lanes;
    if (n > short_list || std::is_sorted(from, from + n)) {
        std::copy(from, from + n, to);
        if (n > short_list) std::sort(to, to + n);
        return;
    }
    typedef Index Lanes __attribute__((vector_size(lanes * sizeof(Index))));
    for (std::size_t start = 0; start < n; start += room_to_sort) {
        std::array<Lanes, vectors> value, below{};
        std::memcpy(value.data(), from + start, sizeof value);
        for (std::size_t m = 0; m < n; ++m)
            for (std::size_t v = 0; v < vectors; ++v) below[v] -= Lanes(from[m] < value[v]);
        std::array<Index, room_to_sort> place;
        std::memcpy(place.data(), below.data(), sizeof place);
        const std::size_t used = std::min(room_to_sort, n - start);
        for (std::size_t k = 0; k < used; ++k) to[place[k]] = from[start + k];
    }
}

/// offsets[i + 1] holds the length of row i on entry, its end on return; makes room for all rows.
inline void lay_out(NeighbourLists& lists) {
    lists.offsets.front() = 0;
    std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
    lists.indices.resize(lists.offsets.back());
}

/// Fills n rows of `lists`. gather(i, row) appends the neighbours of query i to `row`, each once, in
/// any order. Queries run in parallel; the lists do not depend on the number of threads.
template <class Gather> void fill_lists(std::size_t n, NeighbourLists& lists, Gather gather) {
    constexpr std::size_t block_size = 256;
    const std::size_t blocks = (n + block_size - 1) / block_size;
    std::vector<std::vector<Index>> found(blocks);
    lists.offsets.resize(n + 1);
    parallel_for(
        blocks,
        [&](std::size_t b) {
            std::vector<Index> row;
            for (std::size_t i = b * block_size; i < std::min(n, (b + 1) * block_size); ++i) {
                row.clear();
                gather(i, row);
                const std::size_t length = row.size();
                lists.offsets[i + 1] = length;
                row.resize(length + room_to_sort);
                found[b].resize(found[b].size() + length);
                sort_ascending(row.data(), length, found[b].data() + found[b].size() - length);
            }
        },
        1);
    lay_out(lists);
    parallel_for(
        blocks,
        [&](std::size_t b) {
            std::copy(
                found[b].begin(), found[b].end(),
                lists.indices.begin() + static_cast<std::ptrdiff_t>(lists.offsets[b * block_size]));
        },
        1);
}

}  // namespace plumbline
