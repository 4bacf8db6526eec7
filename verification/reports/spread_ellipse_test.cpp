#include "reports/charts/spread_ellipse.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using reports::Chart;
using reports::spread_ellipse;

TEST_CASE("the ellipse of a spread is where the normal density leaves 5 % outside") {
    // Logarithms (0, 0), (1, 2), (2, 1): mean (1, 1), variances 1, covariance 1/2.
    const auto e = [](double power) { return std::exp(power); };
    const Chart::Outline outline = spread_ellipse({e(0), e(1), e(2)}, {e(0), e(2), e(1)});
    double centre_x = 0.0, centre_y = 0.0;
    for (std::size_t k = 0; k < outline.x.size(); ++k) {
        const double a = std::log(outline.x[k]) - 1.0, b = std::log(outline.y[k]) - 1.0;
        // d·C⁻¹d with C⁻¹ = [1, −1/2; −1/2, 1] / (3/4); χ² of 2 degrees exceeds s with exp(−s/2).
        CHECK(std::exp(-0.5 * (a * a - a * b + b * b) / 0.75) == Approx(0.05).epsilon(1e-12));
        centre_x += a;
        centre_y += b;
    }
    CHECK(std::abs(centre_x) < 1e-12);  // all around: 72 roundings of numbers below 4
    CHECK(std::abs(centre_y) < 1e-12);
}

TEST_CASE("the ellipse of points without a spread in x, or in both, is a line or a point") {
    const Chart::Outline line = spread_ellipse({2, 2, 2}, {1, 2, 4});
    CHECK(std::ranges::all_of(line.x, [](double x) { return std::abs(x - 2.0) < 1e-14; }));
    CHECK(*std::ranges::max_element(line.y) > 4.0);
    const Chart::Outline point = spread_ellipse({2, 2}, {3, 3});
    CHECK(std::ranges::all_of(point.y, [](double y) { return std::abs(y - 3.0) < 1e-14; }));
}
