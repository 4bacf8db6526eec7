#include "solver/neighbours/candidates.h"

#include "solver/particles/uniform_random.h"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("candidates: the plain test agrees with squared_distance, also in a periodic box") {
    const Points<3> points = uniform_random(unit_box<3>(), 100, 1);
    const PeriodicBox<3> box(Vec<3>::Zero(), Vec<3>::Ones());
    for (const std::size_t n : {0, 1, 63, 64, 65, 100}) {
        Candidates<3> near;
        near.resize(n);
        for (std::size_t k = 0; k < n; ++k)
            for (int a = 0; a < 3; ++a) near.x(a)[k] = points[k][a];
        near.close();
        REQUIRE(near.words() == (n + 63) / 64);
        const auto check = [&](const auto& space) {
            std::vector<std::uint64_t> within(near.words());
            const Vec<3> q(0.1, 0.5, 0.9);
            std::size_t expected = 0;
            bool same = true;
            const std::size_t found = test_candidates(space, q, 0.16, near, within.data());
            for (std::size_t k = 0; k < n; ++k) {
                const bool closer = squared_distance(space, q, points[k]) < 0.16;
                expected += closer ? 1 : 0;
                same &= closer == ((within[k / 64] >> (k % 64) & 1) != 0);
            }
            CHECK(same);
            CHECK(found == expected);
        };
        check(OpenSpace<3>{});
        check(box);
    }
}
