#include "solver/foundation/parallel.h"

#include <catch2/catch.hpp>

#include <stdexcept>
#include <vector>

namespace parallel_test {
namespace {
using namespace plumbline;

class WithThreads {
public:
    explicit WithThreads(int n) : before_{thread_count()} { set_thread_count(n); }
    ~WithThreads() { set_thread_count(before_); }
    WithThreads(const WithThreads&) = delete;
    WithThreads& operator=(const WithThreads&) = delete;

private:
    int before_;
};

TEST_CASE("parallel_for visits every index once, with any number of threads") {
    for (const int threads : {1, 2, 7}) {
        const WithThreads scope(threads);
        for (const std::size_t n : {0u, 1u, 255u, 256u, 257u, 10000u}) {
            std::vector<int> visits(n, 0);
            parallel_for(n, [&](std::size_t i) { ++visits[i]; });
            CHECK(visits == std::vector<int>(n, 1));
        }
    }
}

TEST_CASE("parallel_for rethrows what a body throws, after all others ran") {
    const WithThreads scope(2);
    std::vector<int> visits(1000, 0);
    const auto body = [&](std::size_t i) {
        if (i == 500) throw std::out_of_range("500");
        ++visits[i];
    };
    CHECK_THROWS_AS(parallel_for(visits.size(), body), std::out_of_range);
    std::vector<int> expected(1000, 1);
    expected[500] = 0;
    CHECK(visits == expected);
}
}  // namespace
}  // namespace parallel_test
