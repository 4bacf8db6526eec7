#include "solver/neighbours/candidates.h"

#include <catch2/catch.hpp>

namespace candidates_test {

using namespace plumbline;

TEST_CASE(
    "candidates: a test knows arrays, centre and box, and what follows the last is at infinity") {
    const PeriodicBox<2> box({-1, -1}, {1, 3});
    Candidates<2, float> near;
    for (const std::size_t n : {0, 1, 15, 16, 17, 40, 3}) {
        near.resize(n);
        for (std::size_t k = 0; k < n; ++k) {
            near.x(0)[k] = static_cast<float>(k);
            near.x(1)[k] = -1.0f;
            near.id()[k] = static_cast<Index>(10 * k);
        }
        near.close();
        const auto test = near.near(box, VecOf<float, 2>(0.5f, 0.25f), 4.0f, n / 2);
        CHECK(test.size == n);
        CHECK(test.from == n / 2);
        CHECK(test.centre[1] == 0.25f);
        CHECK(test.edge[1] == 4.0f);
        CHECK(test.squared_radius == 4.0f);
        CHECK(test.id == near.id());
        for (std::size_t k = 0; k < n; ++k) CHECK(test.x[0][k] == static_cast<float>(k));
        for (std::size_t k = n; k % candidates_per_step != 0; ++k) CHECK(std::isinf(test.x[0][k]));
    }
}

}  // namespace candidates_test
