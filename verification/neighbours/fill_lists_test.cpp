#include "solver/neighbours/fill_lists.h"

#include "solver/foundation/random.h"

#include <catch2/catch.hpp>

namespace fill_lists_test {

using namespace plumbline;

TEST_CASE("sort_ascending: sorts lists of every length, and writes no more") {
    Random random(41);
    for (std::size_t n = 0; n < 700; n += n < 80 ? 1 : 37) {
        std::vector<Index> from(n + room_to_sort, 7u), to(n + 1, 99u);
        for (std::size_t k = 0; k < n; ++k)
            from[k] = static_cast<Index>(random.bits() << 10 | k);  // distinct, also above 2^31
        std::vector<Index> expected(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(n));
        std::ranges::sort(expected);
        expected.push_back(99u);
        sort_ascending(from.data(), n, to.data());
        CHECK(to == expected);
    }
}

TEST_CASE("fill_lists: the rows in order, the same for any number of threads") {
    const auto multiples = [](std::size_t i, std::vector<Index>& row) {
        for (std::size_t k = i % 5; k > 0; --k) row.push_back(static_cast<Index>(k * i));
    };
    const int threads = thread_count();
    NeighbourLists alone, together;
    set_thread_count(1);
    fill_lists(1000, alone, multiples);
    set_thread_count(3);
    fill_lists(1000, together, multiples);
    set_thread_count(threads);
    CHECK(alone == together);
    REQUIRE(alone.size() == 1000);
    const auto row = alone.of(8);
    CHECK(std::vector(row.begin(), row.end()) == std::vector<Index>{8, 16, 24});
}

}  // namespace fill_lists_test
