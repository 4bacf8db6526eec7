#include "solver/approximation/density.h"

#include "solver/kernels/poly6.h"
#include "verification/framework/patch.h"

#include <catch2/catch.hpp>

#include <limits>

namespace density_test {

using namespace plumbline;

TEST_CASE("volumes names the sample whose mass or density is unusable") {
    const Poly6<2> w(1.5);
    const verification::Patch<2> patch(1.0, w.support());
    std::vector<double> m(patch.x.size(), 2.0);
    const auto volumes_of = [&] { return volumes<Poly6<2>>(w, patch.x, m, patch.neighbours); };
    CHECK(volumes_of().size() == m.size());
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        m[3] = bad;
        CHECK_THROWS_WITH(volumes_of(), Catch::Contains("mass") && Catch::Contains("sample 3"));
    }
}

TEST_CASE("volumes refuses a sample that no neighbour list mentions") {
    const Poly6<2> w(1.5);
    const Points<2> x{{0.0, 0.0}};
    const std::vector<double> m{1.0};
    const NeighbourLists nobody{{0, 0}, {}};
    CHECK_THROWS_WITH(volumes<Poly6<2>>(w, x, m, nobody),
                      Catch::Contains("density") && Catch::Contains("sample 0"));
}

}  // namespace density_test
