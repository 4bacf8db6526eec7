#include "solver/kernels/support.h"

#include "solver/kernels/all_kernels.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace support_test {

using namespace plumbline;

TEST_CASE("Support scales lengths without rounding, and clamps them at the rim") {
    for (const double h : {1e-50, 0.7, 1.0, 2.0, 3e17, 1e50}) {
        const Support s("kernel", h);
        CHECK(s.radius() == h);
        CHECK(s.scaled() >= 1.0);
        CHECK(s.scaled() < 2.0);
        const double unit = s.scaled() / h;
        CHECK(std::exp2(std::round(std::log2(unit))) == unit);
        CHECK(s.clamp(0.3 * h) == 0.3 * h * unit);
        CHECK(s.clamp(h) == s.scaled());
        CHECK(s.clamp(std::numeric_limits<double>::infinity()) == s.scaled());
    }
    CHECK(std::isnan(Support("kernel", 1.0).clamp(std::nan(""))));
}

TEST_CASE("kernels of the smallest and largest support are finite, others are refused") {
    for (const double h : {Support::smallest, Support::largest})
        AllKernels::for_each<3>(h, [h](const auto& w) {
            CHECK(std::isnormal(w.value(0.5 * h)));
            CHECK(std::isnormal(w.derivative(0.5 * h)));
            CHECK(std::isnormal(w.second_derivative(0.6 * h)));
        });
    for (const double h : {0.0, -1.0, 9e-51, 2e50, std::nan(""), HUGE_VAL})
        CHECK_THROWS_AS(AllKernels::for_each<2>(h, [](const auto&) {}), InvalidInput);
}

TEST_CASE("a radius that is not a number gives no number") {
    AllKernels::for_each<2>(1.0, [](const auto& w) {
        INFO(w.name);
        CHECK(std::isnan(w.value(std::nan(""))));
        CHECK(std::isnan(w.derivative(std::nan(""))));
        CHECK(std::isnan(w.second_derivative(std::nan(""))));
        CHECK(std::isnan(laplacian(w, std::nan(""))));
    });
}

}  // namespace support_test
