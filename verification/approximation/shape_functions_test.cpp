#include "solver/approximation/shape_functions.h"

#include "solver/approximation/mueller_gradient.h"
#include "solver/kernels/poly6.h"

#include <catch2/catch.hpp>

namespace shape_functions_test {

using namespace plumbline;

TEST_CASE("shape functions refuse a field of another size and a derivative that was not computed") {
    const std::vector<Vec<2>> x{{0, 0}, {1, 0}, {0, 1}};
    const NeighbourLists all{{0, 3}, {0, 1, 2}};
    const MuellerShape<Poly6<2>> mueller{Poly6<2>(2.0)};
    const std::array at{x[0]};
    const auto values = precompute<MuellerShape<Poly6<2>>>(mueller, x, at, all, Derivatives::none);
    const std::vector<double> f{1, 2, 3}, too_few{1, 2};
    CHECK(values.value(f, 0) == 1.0);
    CHECK_THROWS_AS(values.value(too_few, 0), InvalidInput);
    CHECK_THROWS_AS(values.gradient(f, 0), InvalidInput);
    CHECK_THROWS_AS(precompute<MuellerShape<Poly6<2>>>(mueller, x, x, all, Derivatives::none),
                    InvalidInput);
    CHECK_THROWS_AS(precompute<MuellerShape<Poly6<2>>>(mueller, x, at, all, Derivatives::laplacian),
                    InvalidInput);
}

}  // namespace shape_functions_test
