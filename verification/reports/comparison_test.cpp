#include "reports/comparison.h"

#include "solver/foundation/errors.h"

#include <catch2/catch.hpp>

namespace comparison_test {
namespace {
using reports::Change;
using reports::Json;

Json claim(const char* id, const char* verdict) {
    return {{"id", id}, {"verdict", verdict}, {"measured", 1e-9}};
}

Json claims(Json all) { return {{"schema", "plumbline.claims/1"}, {"claims", std::move(all)}}; }

Json study(double low, double high, const char* verdict = "verified") {
    return {{"schema", "plumbline.studies/1"},
            {"studies",
             {{{"id", "s"},
               {"series",
                {{{"name", "mls"},
                  {"verdict", verdict},
                  {"order", 0.5 * (low + high)},
                  {"confidence", {low, high}}}}}}}}};
}

Json timed(double median_s, double mad_s, const char* processor = "cpu", double noise = 0.02) {
    Json result = {{"schema", "plumbline.neighbours/1"},
                   {"provenance", {{"processor", processor}, {"threads", 2}}},
                   {"neighbours",
                    {{{"search", "cell_grid"},
                      {"count", 1000},
                      {"query", {{"median_s", median_s}, {"mad_s", mad_s}}}}}}};
    if (noise > 0.0) result["noise"] = {{"relative", noise}};
    return result;
}

Change::Verdict only(const Json& before, const Json& now) {
    const auto changes = reports::compare(before, now);
    REQUIRE(changes.size() == 1);
    return changes[0].verdict;
}
}  // namespace

TEST_CASE("compare: a claim is better or worse when its verdict is, the worse first") {
    using enum Change::Verdict;
    const auto changes = reports::compare(
        claims({claim("a", "verified"), claim("b", "failed"), claim("c", "verified"),
                claim("d", "verified"), claim("e", "inconclusive")}),
        claims({claim("a", "verified"), claim("b", "verified"), claim("c", "toothless"),
                claim("new", "verified"), claim("e", "inconclusive")}));
    std::vector<std::pair<std::string, Change::Verdict>> found;
    for (const Change& c : changes) found.emplace_back(c.id, c.verdict);
    CHECK(found == std::vector<std::pair<std::string, Change::Verdict>>{{"claims/c", worse},
                                                                        {"claims/b", better},
                                                                        {"claims/d", cannot_tell},
                                                                        {"claims/e", cannot_tell},
                                                                        {"claims/new", cannot_tell},
                                                                        {"claims/a", same}});
}

TEST_CASE("compare: orders differ only when their intervals are apart") {
    using enum Change::Verdict;
    CHECK(only(study(1.8, 2.2), study(1.9, 2.4)) == same);
    CHECK(only(study(1.8, 2.2), study(2.3, 2.4)) == better);
    CHECK(only(study(1.8, 2.2), study(1.2, 1.7)) == worse);
    CHECK(only(study(1.8, 2.2), study(1.8, 2.2, "failed")) == worse);
    CHECK(only(study(1.8, 2.2, "saturated"), study(1.8, 2.2)) == better);
}

TEST_CASE("compare: times below the noise cannot be told apart") {
    using enum Change::Verdict;
    CHECK(only(timed(1.0, 0.001), timed(1.01, 0.001)) == cannot_tell);
    CHECK(only(timed(1.0, 0.001), timed(1.10, 0.001)) == worse);
    CHECK(only(timed(1.0, 0.001), timed(0.90, 0.001)) == better);
    CHECK(only(timed(1.0, 0.050), timed(1.10, 0.050)) == cannot_tell);
    CHECK(only(timed(1.0, 0.001), timed(9.00, 0.001, "another cpu")) == cannot_tell);
    CHECK(only(timed(1.0, 0.001, "cpu", 0), timed(9.00, 0.001)) == cannot_tell);
}

TEST_CASE("compare: what is no result of plumbline is refused") {
    CHECK_THROWS_AS(reports::compare(Json::array(), claims({})), plumbline::InvalidInput);
    CHECK_THROWS_AS(reports::compare(claims({}), Json{{"schema", "junit"}}),
                    plumbline::InvalidInput);
    CHECK_THROWS_AS(reports::compare(claims({{{"id", "a"}}}), claims({{{"id", "a"}}})),
                    plumbline::InvalidInput);
}

}  // namespace comparison_test
