#include "solver/approximation/shepard.h"

#include "solver/kernels/poly6.h"
#include "verification/framework/patch.h"

#include <catch2/catch.hpp>

namespace shepard_test {

using namespace plumbline;

TEST_CASE("Shepard has no value where no sample has weight") {
    const Poly6<2> w(2.5);
    const verification::Patch<2> patch(1.0, w.support());
    const auto s = patch.samples();
    const std::vector<double> f(patch.x.size(), 1.0);
    const Place<2> nowhere{{50.0, 0.0}, {}};
    CHECK_FALSE(shepard(w, s, f, nowhere));
    CHECK_FALSE(shepard_gradient(w, s, f, nowhere));
    CHECK_FALSE(shepard_laplacian(w, s, f, nowhere));
    const Place<2> listed_but_too_far{{50.0, 0.0}, s.neighbours.of(patch.centre)};
    CHECK_FALSE(shepard(w, s, f, listed_but_too_far));
    CHECK(shepard(w, s, f, s.at(patch.centre)));
}

}  // namespace shepard_test
