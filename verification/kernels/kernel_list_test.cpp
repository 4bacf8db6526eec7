#include "solver/kernels/all_kernels.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace kernel_list_test {

using namespace plumbline;

TEST_CASE("the list of kernels holds each where it exists, under its own name") {
    const auto in_1d = AllKernels::names<1>(), in_2d = AllKernels::names<2>();
    CHECK(std::ranges::is_sorted(in_2d));
    CHECK(std::ranges::count(in_2d, "singular") == 1);
    CHECK(std::ranges::count(in_1d, "singular") == 0);
    CHECK(in_2d == AllKernels::names<3>());
    for (const std::string_view name : in_2d)
        AllKernels::with<2>(name, 0.5, [&]<class K>(const K& w) {
            CHECK(K::name == name);
            CHECK(w.support() == 0.5);
        });
    CHECK_THROWS_AS(AllKernels::with<1>("singular", 1.0, [](const auto&) {}), InvalidInput);
}

TEST_CASE("the Laplacian at the centre is the limit, and 0 where there is none") {
    AllKernels::for_each<3>(1.0, []<class K>(const K& w) {
        INFO(K::name);
        if (K::name == "spiky" || K::name == "singular")
            CHECK(laplacian(w, 0.0) == 0.0);
        else
            CHECK(laplacian(w, 0.0) == Approx(laplacian(w, 1e-7)).epsilon(1e-5));
        CHECK(std::isfinite(laplacian(w, 1e-60)));
    });
}

}  // namespace kernel_list_test
