#include "verification/framework/study.h"

#include "solver/foundation/random.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

namespace study_test {
namespace {
using namespace verification;
using Law = std::function<double(double spacing, std::uint64_t seed)>;

const Bound second_order = between(1.5, 2.5, "nearer to 2 than to 1 or 3");

/// A factor in [1 − width, 1 + width), from the level and the seed alone.
double noise(double width, double spacing, std::uint64_t seed) {
    plumbline::Random random(seed + static_cast<std::uint64_t>(1e6 / spacing));
    return 1.0 + random.uniform(-width, width);
}

Study study_of(std::vector<Study::Series> series, std::vector<Law> laws) {
    return {.id = "synthetic.law",
            .source = {Paper::plumbline, "synthetic"},
            .says = "",
            .quantity = "",
            .spacing = {0.1, 0.05, 0.025, 0.0125, 0.00625},
            .series = std::move(series),
            .errors = [laws = std::move(laws)](double spacing, std::uint64_t seed) {
                std::vector<double> errors;
                for (const Law& law : laws) errors.push_back(law(spacing, seed));
                return errors;
            }};
}

std::string_view verdict_of(const Study::Series& series, const Law& law,
                            Effort effort = Effort::full) {
    const StudyResult result = run(study_of({series}, {law}), effort);
    INFO(result.error);
    REQUIRE(result.series.size() == 1);
    return name_of(result.series[0].verdict);
}

double square(double h, std::uint64_t seed) { return h * h * noise(0.02, h, seed); }
double with_floor(double h, std::uint64_t seed) { return (h * h + 1e-3) * noise(0.02, h, seed); }
double diverging(double h, std::uint64_t seed) { return noise(0.02, h, seed) / h; }
double wild(double h, std::uint64_t seed) {
    return h * h * std::pow(20.0, 10.0 * (noise(0.1, h, seed) - 1.0));
}
double bent(double h, std::uint64_t) { return h * std::pow(1.0 + 30.0 * h, 2); }
double no_answer(double, std::uint64_t) { return NAN; }
}  // namespace

TEST_CASE("each trend has its word") {
    const Study::Series rises{"rises", second_order}, rests{"rests", second_order, true};
    CHECK(verdict_of(rises, square) == "verified");
    CHECK(verdict_of(rises, with_floor) == "saturated");
    CHECK(verdict_of(rises, diverging) == "failed");
    CHECK(verdict_of(rises, wild) == "inconclusive");
    CHECK(verdict_of(rises, bent) == "not in asymptotic range");
    CHECK(verdict_of(rises, no_answer) == "inconclusive");
    CHECK(verdict_of(rests, with_floor) == "verified");
    CHECK(verdict_of(rests, square) == "failed");
    CHECK(verdict_of(rests, diverging) == "failed");
}

TEST_CASE("an order of another integer fails") {
    const Study::Series third{"third", between(2.5, 3.5, "nearer to 3 than to 2 or 4")};
    CHECK(verdict_of(third, square) == "failed");
}

TEST_CASE("a sabotaged series shows whether its bound has teeth") {
    const Study::Series sabotaged{"sabotaged", second_order, false, true};
    CHECK(verdict_of(sabotaged, square) == "toothless");
    CHECK(verdict_of(sabotaged, diverging) == "verified");
    CHECK(verdict_of(sabotaged, with_floor) == "verified");
    CHECK(verdict_of(sabotaged, wild) == "inconclusive");
}

TEST_CASE("too few levels are inconclusive, however straight the line") {
    Study study = study_of({{"three", second_order}}, {square});
    study.quick_levels = 3;
    CHECK(run(study, Effort::quick).series[0].verdict == Verdict::inconclusive);
}

TEST_CASE("methods that all flatten at one error blame the reference") {
    const auto reference_error = [](double h, std::uint64_t) { return 1e-3 + h * h; };
    const auto other = [](double h, std::uint64_t) { return 1e-3 + h * h * h; };
    const Study::Series a{"a", second_order}, b{"b", second_order, true};
    const StudyResult coarse = run(study_of({a, b}, {reference_error, other}), Effort::full);
    CHECK(coarse.warning.find("reference is too coarse") != std::string::npos);
    for (const SeriesResult& s : coarse.series) CHECK(s.verdict == Verdict::inconclusive);

    const auto lower = [](double h, std::uint64_t) { return 1e-4 + h * h * h; };
    CHECK(run(study_of({a, b}, {reference_error, lower}), Effort::full).warning.empty());
    CHECK(run(study_of({a, b}, {square, other}), Effort::full).warning.empty());
}

TEST_CASE("answers that are missing are counted, and the rest is fitted") {
    const auto patchy = [](double h, std::uint64_t seed) {
        return seed == 1 ? NAN : square(h, seed);
    };
    const StudyResult result = run(study_of({{"patchy", second_order}}, {patchy}), Effort::full);
    CHECK(result.series[0].failures == 5);
    CHECK(result.series[0].verdict == Verdict::verified);
}

TEST_CASE("what a study throws is its error") {
    const auto broken = [](double, std::uint64_t) -> double { throw std::runtime_error("broken"); };
    const StudyResult result = run(study_of({{"a", second_order}}, {broken}), Effort::quick);
    CHECK(result.error == "broken");
    CHECK(result.series.empty());
}

}  // namespace study_test
