#include "benchmarks/approximation/frontier.h"
#include "benchmarks/framework/figures.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace frontier_test {
namespace {
using namespace benchmarks;

/// One sample, so that the time per field is the time per place.
Candidate candidate(std::string method, double seconds, double error, std::size_t failures = 0) {
    Candidate c{};
    c.method = std::move(method);
    c.kernel = "poly6";
    c.support_in_spacings = 2.5;
    c.samples_per_metre = 1;
    c.dim = 2;
    c.error = error;
    c.failures = failures;
    c.places = 10;
    c.evaluation = {seconds, 0.0};
    return c;
}
using Methods = std::vector<std::string>;

Methods front_of(const std::vector<Candidate>& candidates) {
    Methods methods;
    for (const std::size_t k : pareto_front(candidates, &Candidate::per_field_s))
        methods.push_back(candidates[k].method);
    return methods;
}
}  // namespace

TEST_CASE("the Pareto front has what nothing beats, by ascending cost") {
    CHECK(front_of({candidate("slow", 3, 1e-3), candidate("dominated", 4, 1e-2),
                    candidate("fast", 1, 1e-1), candidate("middle", 2, 1e-2)}) ==
          Methods{"fast", "middle", "slow"});
}

TEST_CASE("of equal costs the front has the more accurate one, of equals one") {
    CHECK(front_of({candidate("worse", 1, 1e-1), candidate("better", 1, 1e-2),
                    candidate("same", 1, 1e-2)})
              .size() == 1);
}

TEST_CASE("what failed is never on the front") {
    CHECK(front_of({candidate("singular", 1, 1e-9, 1), candidate("no number", 1, NAN),
                    candidate("good", 2, 1e-3)}) == Methods{"good"});
}

TEST_CASE(
    "a finding says who is cheaper, by how much, at which error, and up to where it was looked") {
    std::vector<Candidate> candidates{candidate("SPH Eq. 3", 40, 0.9e-2),
                                      candidate("SPH Eq. 3", 3, 0.9e-1),
                                      candidate("MLS 2", 1, 0.8e-2), candidate("MLS 2", 5, 1e-5)};
    for (Candidate& c : candidates) c.samples_per_metre = 80;
    CHECK(
        finding_of(candidates, 0.05) ==
        "at 1e-01 MLS 2 is 3.0x cheaper than SPH Eq. 3; at 1e-02 MLS 2 is 40x cheaper than SPH Eq. "
        "3, the least of SPH up to h/dx = 2.5 and 80 samples per metre; MLS 2 reaches 1e-05");
}

TEST_CASE("a finding turns round when SPH is cheaper") {
    CHECK(finding_of({candidate("SPH Eq. 3", 1, 1e-2), candidate("MLS 1", 3, 1e-2)}, 0.05)
              .starts_with(
                  "at 1e-01 SPH Eq. 3 is 3.0x cheaper than MLS 1; at 1e-02 SPH Eq. 3 is 3.0x"));
}

TEST_CASE("below the noise nobody is cheaper") {
    const auto finding =
        finding_of({candidate("SPH Eq. 3", 1.04, 1e-2), candidate("MLS 1", 1, 1e-2)}, 0.05);
    CHECK(finding.find("cannot tell") != std::string::npos);
}

TEST_CASE("a finding survives that only one kind of method works") {
    CHECK(finding_of({candidate("SPH Eq. 3", 1, NAN), candidate("MLS 1", 1, 1e-2)}, 0.05)
              .find("nothing to compare") != std::string::npos);
    CHECK(finding_of({candidate("SPH Eq. 3", 1, 1e-3), candidate("MLS 1", 1, 1e-2)}, 0.05)
              .find("at 1e-03 only SPH Eq. 3 answers") != std::string::npos);
}

TEST_CASE("precomputed methods are compared with the SPH sum of their own situation") {
    std::vector<Candidate> candidates;
    for (const double scale : {1.0, 10.0}) {
        for (const std::string method : {"SPH Eq. 3", "MLS 2"}) {
            const bool sph = method != "MLS 2";
            Candidate c = candidate(method, sph ? 2 * scale : 50 * scale, 1e-2);
            c.samples_per_metre = static_cast<int>(scale);
            c.precomputation = {20 * scale, 0};
            c.application = {sph ? scale : 1.5 * scale, 0};
            candidates.push_back(c);
        }
    }
    const auto ratios = precomputed_ratios(candidates, 0.05);
    REQUIRE(ratios.size() == 2);
    CHECK(ratios[0].method == "MLS 2");
    CHECK(ratios[0].over_sph_sum.median == Approx(0.75));
    CHECK(ratios[0].over_precomputed_sph.median == Approx(1.5));
    CHECK(ratios[0].precomputation_in_sums == Approx(10.0));
    CHECK(ratios[0].pays_over_itself == Approx(20.0 / (50.0 - 1.5)));
    CHECK(ratios[0].pays_over_sph == Approx(20.0 / (2.0 - 1.5)));
    CHECK(ratios[0].verdict == "does not hold");  // like with like, though the sum takes longer
    CHECK(ratios[1].method == "SPH Eq. 3");
    CHECK(ratios[1].over_precomputed_sph.median == Approx(1.0));
    CHECK(ratios[1].verdict == "measure of the others");
    for (Candidate& c : candidates)
        if (c.method == "MLS 2") c.application->median_s /= 1.5;
    CHECK(precomputed_ratios(candidates, 0.05)[0].verdict == "holds");
    for (Candidate& c : candidates) c.application->median_s *= 2.0;
    CHECK(precomputed_ratios(candidates, 0.05)[0].pays_over_sph == HUGE_VAL);
}

TEST_CASE("what failed, and situations of SPH alone, are not compared") {
    std::vector<Candidate> candidates;
    for (const int samples : {1, 2, 3})
        for (const std::string method : {"SPH Eq. 3", "MLS 2"}) {
            if (samples == 3 && method == "MLS 2") continue;
            Candidate c = candidate(method, 2.0, samples == 2 && method == "MLS 2" ? NAN : 1e-2);
            c.samples_per_metre = samples;
            c.precomputation = {1.0, 0};
            c.application = {1.0 * samples, 0};
            candidates.push_back(c);
        }
    for (const auto& ratio : precomputed_ratios(candidates, 0.05)) {
        CHECK(ratio.over_sph_sum.lowest == Approx(0.5));
        CHECK(ratio.over_sph_sum.highest == Approx(0.5));
    }
}

TEST_CASE("a factor in a sentence has two figures, and a power of ten only far from 1") {
    CHECK(factor_in_words(1.84) == "1.8");
    CHECK(factor_in_words(9.96) == "10");
    CHECK(factor_in_words(42.4) == "42");
    CHECK(factor_in_words(99.6) == "100");
    CHECK(factor_in_words(178.0) == "180");
    CHECK(factor_in_words(0.051) == "0.051");
    CHECK(factor_in_words(99999.0) == "1.0·10⁵");
    CHECK(factor_in_words(2.34e12) == "2.3·10¹²");
    CHECK(factor_in_words(4.1e-5) == "4.1·10⁻⁵");
    CHECK(factor_in_words(NAN) == "none");
}

}  // namespace frontier_test
