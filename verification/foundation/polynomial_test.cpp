#include "solver/foundation/polynomial.h"

#include <catch2/catch.hpp>

namespace polynomial_test {

TEST_CASE("polynomial evaluates coefficients in ascending order") {
    CHECK(plumbline::polynomial(std::array{3.0}, 7.0) == 3.0);
    CHECK(plumbline::polynomial(std::array{1.0, 2.0, 4.0}, 3.0) == 43.0);
}

}  // namespace polynomial_test
