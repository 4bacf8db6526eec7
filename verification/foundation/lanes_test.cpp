#include "solver/foundation/lanes.h"

#include <catch2/catch.hpp>

#include <array>
#include <numeric>

namespace lanes_test {
namespace {
using namespace plumbline;

template <class Real> Lanes<Real> counted_from(double start) {
    Lanes<Real> lanes;
    for (std::size_t k = 0; k < Lanes<Real>::size; ++k)
        lanes.v[k] = static_cast<Real>(start + static_cast<double>(k));
    return lanes;
}

TEMPLATE_TEST_CASE("lanes are computed with like numbers", "", float, double) {
    const auto a = counted_from<TestType>(1.0), b = counted_from<TestType>(-2.0);
    for (std::size_t k = 0; k < Lanes<TestType>::size; ++k) {
        const TestType x = a.v[k], y = b.v[k];
        CHECK((a + b).v[k] == x + y);
        CHECK((a - b).v[k] == x - y);
        CHECK((2.0 * a * b).v[k] == 2 * x * y);
        CHECK((b / a).v[k] == y / x);
        CHECK((-a).v[k] == -x);
        CHECK(sqrt(a).v[k] == std::sqrt(x));
        CHECK(min(b, Lanes<TestType>(0.5)).v[k] == std::min(y, TestType(0.5)));
        CHECK(max(b, Lanes<TestType>(0.5)).v[k] == std::max(y, TestType(0.5)));
        CHECK(nearest_image(b, Lanes<TestType>(3.0)).v[k] == (y > 1.5    ? y - 3
                                                              : y < -1.5 ? y + 3
                                                                         : y));
    }
    const double n = static_cast<double>(Lanes<TestType>::size);
    CHECK(sum(a) == n * (n + 1) / 2);
}

TEMPLATE_TEST_CASE("four numbers of each record are gathered into lanes", "", float, double) {
    constexpr std::size_t stride = 12, records = 40, lanes = Lanes<TestType>::size;
    std::vector<TestType> numbers(stride * records);
    std::iota(numbers.begin(), numbers.end(), TestType(0));
    std::array<Index, lanes> rows;
    for (std::size_t k = 0; k < lanes; ++k) rows[k] = static_cast<Index>((7 * k + 3) % records);
    Lanes<TestType> out[4];
    for (const std::size_t block : {0, 4, 8}) {
        gather_four(numbers.data() + block, stride, rows.data(), out);
        for (std::size_t k = 0; k < lanes; ++k)
            for (std::size_t f = 0; f < 4; ++f)
                CHECK(out[f].v[k] == static_cast<TestType>(rows[k] * stride + block + f));
    }
}

TEST_CASE("vectors of lanes are lanes of vectors") {
    LaneVector<double, 3> a, b;
    for (int d = 0; d < 3; ++d)
        a.x[d] = counted_from<double>(d), b.x[d] = counted_from<double>(2.0 * d);
    for (std::size_t k = 0; k < Lanes<double>::size; ++k) {
        const auto n = static_cast<double>(k);
        const Vec<3> p(n, n + 1, n + 2), q(n, n + 2, n + 4);
        CHECK(dot(a, b).v[k] == p.dot(q));
        for (int d = 0; d < 3; ++d) {
            CHECK((a + b).x[d].v[k] == p[d] + q[d]);
            CHECK((a - b).x[d].v[k] == p[d] - q[d]);
            CHECK((2.0 * a).x[d].v[k] == 2 * p[d]);
        }
    }
    CHECK(sum(a)[1] - sum(a)[0] == static_cast<double>(Lanes<double>::size));
    CHECK(sum(LaneVector<double, 3>::zero()) == Vec<3>::Zero());
}
}  // namespace
}  // namespace lanes_test
