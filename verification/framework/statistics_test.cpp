#include "verification/framework/statistics.h"

#include "solver/foundation/errors.h"
#include "solver/foundation/random.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace statistics_test {
namespace {
using namespace verification;
using Errors = std::vector<std::vector<double>>;

const std::vector<double> halving{1.0 / 20, 1.0 / 40, 1.0 / 80, 1.0 / 160};

double normal(plumbline::Random& random) {
    return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) *
           std::cos(2.0 * std::numbers::pi * random.uniform());
}

/// law(h) e^(scatter of the seed + shift of the level), both normal.
template <class Law>
Errors sample(Law law, int seeds, double scatter, double shift, plumbline::Random& random) {
    Errors errors;
    for (const double h : halving) {
        const double level = shift * normal(random);
        errors.emplace_back();
        for (int s = 0; s < seeds; ++s)
            errors.back().push_back(law(h) * std::exp(level + scatter * normal(random)));
    }
    return errors;
}

template <class Law> Errors exact(Law law) {
    Errors errors;
    for (const double h : halving) errors.push_back({law(h)});
    return errors;
}

/// How often in 1000 studies the interval misses the true order.
int misses(double scatter, double shift) {
    plumbline::Random random(7);
    int missed = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const auto errors = sample([](double h) { return h * h; }, 5, scatter, shift, random);
        missed += !fit_power_law(halving, errors).confidence.contains(2.0);
    }
    return missed;
}
}  // namespace

TEST_CASE("a pure power law gives its order, no width, no floor, and Roache's index") {
    const PowerLaw law = fit_power_law(halving, exact([](double h) { return 3.0 * h * h; }));
    CHECK(law.order == Approx(2.0).epsilon(1e-12));
    CHECK(law.confidence.high - law.confidence.low < 1e-6);
    CHECK(law.floor < 1e-6 * law.error.back());
    CHECK(law.local_orders.size() == 3);
    CHECK(law.local_orders[1] == Approx(2.0));
    CHECK(law.safety_factor == 1.25);
    // (e₂ − e₁) / (2² − 1) = (4 − 1) e₁ / 3 = e₁
    CHECK(law.grid_convergence_index == Approx(1.25 * law.error.back()));
}

TEST_CASE("the floor of a power law with a floor is found") {
    for (const double p : {1.0, 2.0, 3.7}) {
        const auto errors = exact([p](double h) { return std::pow(h, p) + 1e-3; });
        CHECK(fit_power_law(halving, errors).floor == Approx(1e-3).epsilon(1e-3));
    }
}

TEST_CASE("an error that never changes is all floor") {
    const PowerLaw law = fit_power_law(halving, exact([](double) { return 0.02; }));
    CHECK(law.order == Approx(0.0).margin(1e-12));
    CHECK(law.floor == Approx(0.02));
}

TEST_CASE("divergence has a negative order and no floor") {
    const PowerLaw law = fit_power_law(halving, exact([](double h) { return 1.0 / h; }));
    CHECK(law.order == Approx(-1.0));
    CHECK(law.floor == 0.0);
    CHECK(law.safety_factor == 3.0);
}

TEST_CASE("an error that rises in between is charged with the spread of all levels") {
    const PowerLaw law = fit_power_law(halving, {{8.0}, {1.0}, {3.0}, {2.0}});
    CHECK(law.safety_factor == 3.0);
    CHECK(law.grid_convergence_index == Approx(3.0 * 0.5 * (8.0 - 1.0)));
}

TEST_CASE("an order far from the formal one costs the larger safety factor") {
    const auto errors = exact([](double h) { return h * h * h; });
    CHECK(fit_power_law(halving, errors, 3.0).safety_factor == 1.25);
    CHECK(fit_power_law(halving, errors, 1.0).safety_factor == 3.0);
}

// Of 1000 intervals of 95 % at most 50 may miss; 50 + 3 sqrt(1000 · 0.05 · 0.95) = 71 is three
// standard deviations of that count away.
TEST_CASE("the interval of the order covers the truth when seeds scatter") {
    CHECK(misses(0.1, 0.0) <= 71);
}
TEST_CASE("the interval of the order covers the truth when all seeds of a level share its error") {
    CHECK(misses(0.02, 0.2) <= 71);
}

TEST_CASE("more seeds do not narrow what the levels leave open") {
    plumbline::Random random(3);
    const auto bent = [](double h) { return h * h * (1.0 + 10.0 * h); };
    const PowerLaw few = fit_power_law(halving, sample(bent, 5, 1e-3, 0.0, random));
    const PowerLaw many = fit_power_law(halving, sample(bent, 500, 1e-3, 0.0, random));
    CHECK(many.confidence.high - many.confidence.low ==
          Approx(few.confidence.high - few.confidence.low).epsilon(0.05));
}

TEST_CASE("errors that are not positive and finite are left out") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const PowerLaw law =
        fit_power_law(halving, {{nan, 1.0}, {0.25, nan}, {0.0625, HUGE_VAL}, {nan, nan}});
    CHECK(law.order == Approx(2.0));
    CHECK(law.error.size() == 3);
}

TEST_CASE("what cannot be fitted is refused with a reason") {
    using plumbline::InvalidInput;
    const std::vector<double> two{0.1, 0.05}, rising{0.05, 0.1};
    CHECK_THROWS_AS(fit_power_law(two, {{1.0}}), InvalidInput);
    CHECK_THROWS_AS(fit_power_law(two, {{1.0}, {-1.0}}), InvalidInput);
    CHECK_THROWS_AS(fit_power_law(rising, {{1.0}, {1.0}}), InvalidInput);
    CHECK(std::isinf(fit_power_law(two, {{1.0}, {0.5}}).confidence.high));
}

TEST_CASE("median") {
    CHECK(median({3.0, 1.0, 2.0}) == 2.0);
    CHECK(median({4.0, 1.0, 2.0, 3.0}) == 2.5);
    CHECK(median({NAN, 1.0}) == 1.0);
    CHECK(std::isnan(median({})));
}

}  // namespace statistics_test
