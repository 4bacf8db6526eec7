#include "solver/foundation/sum.h"

#include <catch2/catch.hpp>

namespace sum_test {
namespace {
using namespace plumbline;

TEST_CASE("sum adds in the order given") {
    const std::vector<double> terms{1e16, 1.0, -1e16, 1.0};
    const auto term = [&](Index j) { return terms[j]; };
    // 1e16 + 1 rounds to 1e16: the first 1 is lost, unless it comes after the large terms.
    CHECK(sum<double>(std::vector<Index>{0, 1, 2, 3}, term) == 1.0);
    CHECK(sum<double>(std::vector<Index>{0, 2, 1, 3}, term) == 2.0);
}

TEST_CASE("sum over nobody is zero") {
    const std::vector<Index> nobody;
    CHECK(sum<double>(nobody, [](Index) { return 1.0; }) == 0.0);
    CHECK(sum<Vec<3>>(nobody, [](Index) -> Vec<3> { return {1, 1, 1}; }) == Vec<3>::Zero());
    CHECK(sum<Mat<2>>(nobody, [](Index) -> Mat<2> { return Mat<2>::Ones(); }) == Mat<2>::Zero());
}

template <class T, class Term>
concept CanSum = requires(std::vector<Index> js, Term term) {
    sum<T>(js, term);
};

TEST_CASE("sum refuses a term that is an Eigen expression") {
    const auto vector = [](Index) -> Vec<2> { return {1, 1}; };
    const auto expression = [](Index) { return 2.0 * Vec<2>(1, 1); };
    STATIC_REQUIRE(CanSum<Vec<2>, decltype(vector)>);
    STATIC_REQUIRE(!CanSum<Vec<2>, decltype(expression)>);
}
}  // namespace
}  // namespace sum_test
