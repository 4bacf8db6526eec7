#include "solver/approximation/at_all.h"

#include <catch2/catch.hpp>

#include <stdexcept>

namespace at_all_test {

using namespace plumbline;

TEST_CASE("at_all holds op(i) in row i, with any number of threads") {
    const auto square = [](Index i) { return 0.5 * i * i; };
    const int threads = thread_count();
    for (const int n : {1, 2, 7}) {
        set_thread_count(n);
        const std::vector<double> squares = at_all(1000, square);
        REQUIRE(squares.size() == 1000);
        for (Index i = 0; i < 1000; ++i) REQUIRE(squares[i] == square(i));
    }
    set_thread_count(threads);
    CHECK(at_all(0, square).empty());
}

TEST_CASE("at_all passes on what op throws") {
    const auto fails = [](Index i) -> int {
        if (i == 500) throw std::runtime_error("500");
        return 0;
    };
    CHECK_THROWS_AS(at_all(1000, fails), std::runtime_error);
}

}  // namespace at_all_test
