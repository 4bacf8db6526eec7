#include "verification/framework/validation.h"

#include "solver/foundation/errors.h"

#include <catch2/catch.hpp>

namespace validation_test {
namespace {
using namespace verification;

/// S = limit + h^order on these levels.
std::vector<double> power_law(const std::vector<double>& spacing, double order, double limit) {
    std::vector<double> values;
    for (const double h : spacing) values.push_back(limit + std::pow(h, order));
    return values;
}

Validation synthetic(double measured, double u_data) {
    return {.id = "synthetic",
            .source = {Paper::plumbline, "synthetic"},
            .says = "",
            .what_is_run = "",
            .spacing = {0.4, 0.2, 0.1},
            .quantities = {{.name = "q",
                            .unit = "1",
                            .measured = measured,
                            .u_data = u_data,
                            .u_input = 0.0,
                            .why = ""}},
            .panels = {{.name = "p",
                        .x_label = "x",
                        .x_unit = "1",
                        .y_label = "y",
                        .y_unit = "1",
                        .measured = {{0.0, 1.0, 2.0, 5.0}, {0.0, 1.0, 2.0, 5.0}},
                        .low = {-0.1, 0.9, 1.9, 4.9},
                        .high = {0.1, 1.1, 2.1, 5.1},
                        .goal = at_least(0.5, "half")}},
            .observe = {}};
}
Validation::Observation observation(double value, std::vector<double> y) {
    return {{value}, {Curve{{0.0, 2.0}, std::move(y)}}};
}
}  // namespace

TEST_CASE("numerical uncertainty is 1.25 times the error that a power law has left") {
    const std::vector<double> uneven{0.4, 0.25, 0.1};
    for (const double order : {0.6, 1.0, 1.7})
        CHECK(numerical_uncertainty(uneven, power_law(uneven, order, 3.0), 2.0) ==
              Approx(1.25 * std::pow(0.1, order)).epsilon(1e-6));
}

TEST_CASE("an order beyond the formal one is not believed, and safety is 3 where it is far off") {
    const std::vector<double> h{0.4, 0.2, 0.1};
    // Formal order 1: h² has halves 0.12, 0.03; the last step is taken for a first-order one.
    CHECK(numerical_uncertainty(h, power_law(h, 2.0, 1.0), 1.0) == Approx(1.25 * 0.03));
    CHECK(numerical_uncertainty(h, power_law(h, 3.0, 1.0), 1.0) == Approx(3.0 * 0.007));
    const double step = std::pow(0.2, 0.2) - std::pow(0.1, 0.2);
    CHECK(numerical_uncertainty(h, power_law(h, 0.2, 1.0), 1.0) ==
          Approx(3.0 * step / (std::sqrt(2.0) - 1.0)));
}

TEST_CASE("numerical uncertainty of levels that go up and down is 3 times half their spread") {
    CHECK(numerical_uncertainty({0.8, 0.4, 0.2, 0.1}, {9.0, 2.0, 3.0, 1.0}, 1.0) == Approx(12.0));
    CHECK(numerical_uncertainty({0.4, 0.2, 0.1}, {2.0, 2.0, 2.0}, 1.0) == 0.0);
    CHECK(std::isnan(numerical_uncertainty({0.2, 0.1}, {1.0, 2.0}, 1.0)));
    CHECK(std::isnan(numerical_uncertainty({0.4, 0.2, 0.1}, {1.0, NAN, 2.0}, 1.0)));
}

TEST_CASE("a comparison agrees, differs, or says nothing") {
    // S = 1 + h, so u_num = 0.125 and E = 1.1 − D.
    const std::vector<double> h{0.4, 0.2, 0.1};
    const auto agreement = [&](double measured, double u_data, double finest = 1.1) {
        std::vector<Validation::Observation> observed;
        for (const double s : {1.4, 1.2, finest}) observed.push_back(observation(s, {0.0, 2.0}));
        return judge(synthetic(measured, u_data), h, observed).quantities[0];
    };
    CHECK(agreement(1.0, 0.0).agreement == Agreement::agrees);
    CHECK(agreement(0.9, 0.0).agreement == Agreement::differs);
    CHECK(agreement(0.9, 0.2).agreement == Agreement::agrees);
    CHECK(agreement(0.9, 0.2).u_val == Approx(std::hypot(0.2, 0.125)));
    CHECK(agreement(-0.1, 0.0).agreement == Agreement::inconclusive);
    CHECK(agreement(1.0, 0.0, NAN).agreement == Agreement::inconclusive);
}

TEST_CASE("a signal is compared where both were sampled") {
    const Validation v = synthetic(1.0, 0.0);
    const auto compared = [&](std::vector<double> y) {
        return judge(v, {0.1}, {observation(1.0, std::move(y))}).panels[0];
    };
    CHECK(compared({0.0, 2.0}).deviation == Approx(0.0).margin(1e-15));
    CHECK(compared({0.0, 2.0}).inside_band == 1.0);
    // At 0, 1 and 2 by 0.3, 0.15 and 0 too high; the range of the data is 5.
    const PanelResult tilted = compared({0.3, 2.0});
    CHECK(tilted.deviation == Approx(std::sqrt((0.09 + 0.0225) / 3.0) / 5.0));
    CHECK(*tilted.inside_band == Approx(1.0 / 3.0));
    CHECK_FALSE(tilted.reaches_goal);
}

TEST_CASE("an observation that lacks a number is refused") {
    CHECK_THROWS_AS(judge(synthetic(1.0, 0.0), {0.1}, {Validation::Observation{{}, {Curve{}}}}),
                    plumbline::InvalidInput);
    CHECK_THROWS_AS(judge(synthetic(1.0, 0.0), {0.1}, {}), plumbline::InvalidInput);
}

TEST_CASE("registered validations have what a comparison needs") {
    REQUIRE_FALSE(validations().empty());
    for (const Validation& v : validations()) {
        INFO(v.id);
        CHECK(v.spacing.size() >= 3);
        CHECK(std::ranges::is_sorted(v.spacing, std::greater()));
        CHECK((v.quick_levels == 0 || v.quick_levels >= 3));
        CHECK(v.quick_levels <= std::ssize(v.spacing));
        CHECK_FALSE(v.quantities.size() + v.panels.size() == 0);
        for (const auto& q : v.quantities) CHECK_FALSE(q.why.empty());
        for (const auto& p : v.panels) {
            CHECK(p.measured.x.size() == p.measured.y.size());
            CHECK(std::ranges::is_sorted(p.measured.x));
            CHECK(p.low.size() == p.high.size());
        }
    }
}

}  // namespace validation_test
