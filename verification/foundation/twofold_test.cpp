#include "solver/foundation/twofold.h"

#include "solver/foundation/random.h"
#include "verification/framework/oracle.h"

#include <catch2/catch.hpp>

namespace twofold_test {

using namespace plumbline;
using verification::Real50;

namespace {
Real50 whole(const Twofold& a) { return Real50(a.value) + Real50(a.rest); }
double relative(const Real50& found, const Real50& exact) {
    return abs((found - exact) / exact).convert_to<double>();
}
}  // namespace

TEST_CASE("sums, differences and squares keep every bit, and products 100 of them") {
    Random random(1);
    for (int k = 0; k < 1000; ++k) {
        const double a = random.uniform(1.0, 2.0), b = a * random.uniform();
        CHECK(whole(difference(a, b)) == Real50(a) - Real50(b));
        CHECK(whole(sum(a, b)) == Real50(a) + Real50(b));
        CHECK(whole(square(a)) == Real50(a) * Real50(a));
        const Twofold d = difference(a, b), s = sum(a, b);
        const Real50 exact = whole(d) * whole(s);
        CHECK(relative(whole(d * s), exact) < 0x1p-100);
        CHECK(relative(Real50(rounded_product(d, s)), exact) < 0x1.01p-53);
    }
}

}  // namespace twofold_test
