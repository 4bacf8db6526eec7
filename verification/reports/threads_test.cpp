#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace threads_test {
namespace {
using namespace verification;
using nlohmann::json;

/// Whether a value may differ from run to run: times, what the allocator adds, and what is derived
/// from them.
bool is_of_times(const std::string& key) {
    static const std::set<std::string> derived{
        "provenance",    "seconds",     "threads",      "command",
        "noise",         "finding",     "on_front",     "statement",
        "charts",        "first_place", "last_place",   "held_bytes",
        "lists_bytes",   "peak_bytes",  "over_fastest", "over_fastest_spread",
        "recommendation"};
    return key.ends_with("_s") || derived.contains(key);
}
json without_times(const json& value) {
    json kept = value.is_array() ? json::array() : json::object();
    if (value.is_string())
        return std::regex_replace(value.get<std::string>(), std::regex(", \\d+ threads?"), "");
    if (!value.is_structured()) return value;
    for (const auto& [key, inner] : value.items()) {
        if (value.is_array())
            kept.push_back(without_times(inner));
        else if (!is_of_times(key))
            kept[key] = without_times(inner);
    }
    return kept;
}

json result_of(std::vector<std::string> arguments, const std::string& threads) {
    const ScratchFolder folder;
    arguments.insert(arguments.begin(), {"--threads", threads});
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramRun run = run_plumbline(folder, arguments, 600);
    INFO(run.err);
    REQUIRE_FALSE(run.out.empty());
    return without_times(json::parse(run.out));
}

/// Of a run with one thread and of another one with two.
void check_that_results_are_equal(const std::vector<std::string>& arguments,
                                  const std::string& results) {
    const json one = result_of(arguments, "1").at(results);
    REQUIRE_FALSE(one.empty());
    const json other = result_of(arguments, "2").at(results);
    REQUIRE(other.size() == one.size());
    if (!one.is_array()) CHECK(one.dump() == other.dump());
    for (std::size_t i = 0; one.is_array() && i < one.size(); ++i)
        CHECK(one[i].dump() == other[i].dump());
}
}  // namespace

TEST_CASE("claims do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"verify"}, "claims");
}
TEST_CASE("studies do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"converge", "--quick", "gradient_2d_jittered", "value_3d_halton"},
                                 "studies");
}
TEST_CASE("apart from times frontiers do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"frontier", "--quick", "approximation", "--dim", "2"},
                                 "frontiers");
}
TEST_CASE(
    "apart from times frontiers of fluids do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"frontier", "--quick", "hydrostatic"}, "frontiers");
}
TEST_CASE("maps of stability do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"stability", "--quick", "pairing"}, "maps");
}
TEST_CASE("apart from times searches do not depend on the number of threads, nor on the run") {
    check_that_results_are_equal({"neighbours", "--quick", "--count", "2000", "--cloud", "graded"},
                                 "neighbours");
}
TEST_CASE("what is left out is times, and nothing else is equal by being left out") {
    const json kept = without_times(json::parse(
        R"({"a": [{"median_s": 1, "error": 2}], "noise": 3, "charts": [], "count": 4})"));
    CHECK(kept == json::parse(R"({"a": [{"error": 2}], "count": 4})"));
}

}  // namespace threads_test
