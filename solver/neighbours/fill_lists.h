#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/neighbour_lists.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace plumbline {

/// Writes the n distinct numbers of `from` to `to`, ascending. Neighbour lists are short: up to
/// `short_list` the place of each number is the count of those below it, a loop without branches that
/// the compiler vectorises.
inline void sort_ascending(const Index* from, std::size_t n, Index* to) {
    constexpr std::size_t short_list = 256;
    if (n > short_list || std::is_sorted(from, from + n)) {
        std::copy(from, from + n, to);
        if (n > short_list) std::sort(to, to + n);
        return;
    }
    std::array<Index, short_list> place;
    std::fill_n(place.begin(), n, Index{0});
    for (std::size_t m = 0; m < n; ++m) {
        const Index other = from[m];
        for (std::size_t k = 0; k < n; ++k) place[k] += other < from[k] ? 1u : 0u;
    }
    for (std::size_t k = 0; k < n; ++k) to[place[k]] = from[k];
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
                lists.offsets[i + 1] = row.size();
                found[b].resize(found[b].size() + row.size());
                sort_ascending(row.data(), row.size(),
                               found[b].data() + found[b].size() - row.size());
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
