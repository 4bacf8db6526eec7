// The forms in which results leave the program: JSON and JUnit.
#include "reports/json.h"
#include "reports/junit.h"
#include "reports/measurements.h"
#include "reports/process.h"
#include "reports/words.h"

#include <boost/property_tree/xml_parser.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace results_test {
namespace {
using namespace verification;
using reports::Json;
using reports::json_of;

ClaimResult result(const char* id, Verdict verdict, double measured) {
    return {.claim = {.id = id,
                      .source = {Paper::adams2009, "Eq. 13"},
                      .says = "a < b & \"c\"",
                      .bound = at_most(1e-6, "rounding <= 1e-6"),
                      .measure = {},
                      .tags = {}},
            .verdict = verdict,
            .measured = measured,
            .sabotaged = 1.0,
            .seconds = 0.25,
            .error = {}};
}
}  // namespace

TEST_CASE("a claim in JSON has the promised members, and a word for what is infinite") {
    const Json json = json_of(result("a.b", Verdict::verified, 1e-9));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"id", "source", "says", "measured", "bound", "verdict",
                                           "sabotaged", "seconds"});
    CHECK(json["bound"] == Json{{"low", "-inf"}, {"high", 1e-6}, {"why", "rounding <= 1e-6"}});
    CHECK(json["sabotaged"] == Json{{"measured", 1.0}, {"caught", true}});
    CHECK(json_of(result("a.b", Verdict::failed, NAN))["measured"].is_null());
    CHECK(json_of(result("a.b", Verdict::failed, HUGE_VAL))["measured"] == "inf");
}

TEST_CASE("which mutants a claim depends on is read back from JSON") {
    const Claim& claim = verification::claims().front();
    Mutant* const mutant = verification::mutants().back();
    ClaimResult measured{claim, Verdict::verified, 0.0, {}, 0.0, {}, {mutant}};
    Json results = Json::array({json_of(measured), json_of(result("a.b", Verdict::verified, 0))});
    const auto read = reports::dependents(results);
    REQUIRE(read.size() == 1);
    CHECK(read[0].id == claim.id);
    CHECK(read[0].on == std::vector{mutant});
    results[0]["depends_on"][0] = "Eq. 0";
    CHECK_THROWS_WITH(reports::dependents(results), "not registered: Eq. 0");
}

TEST_CASE("what JSON has no number for comes back as it was") {
    for (const double x : {1.5, 0.0, HUGE_VAL, -HUGE_VAL})
        CHECK(reports::value_of(reports::number(x)) == x);
    CHECK(std::isnan(reports::value_of(reports::number(NAN))));
}

TEST_CASE("an order that rounds to zero has no sign") {
    CHECK(reports::order_in_words(-0.02) == "0.0");
    CHECK(reports::order_in_words(-1.04) == "-1.0");
}

TEST_CASE("a bound that is open on one side is told in words") {
    CHECK(reports::bound_in_words(json_of(at_most(1e-6, ""))) == "≤ 1e-06");
    CHECK(reports::bound_in_words(json_of(at_least(2.0, ""))) == "≥ 2");
    CHECK(reports::short_number(reports::number(HUGE_VAL)) == "∞");
}

TEST_CASE("a document names its schema and where it comes from") {
    const Json json = reports::document("claims", Json::array());
    CHECK(json["schema"] == "plumbline.claims/1");
    for (const char* key : {"version", "compiler", "flags", "processor", "cores", "memory_gb",
                            "threads", "libraries", "seeds", "command_line", "started"})
        CHECK(json["provenance"].contains(key));
    CHECK(Json::parse(json.dump()) == json);
}

TEST_CASE("JUnit is XML that counts what failed") {
    std::istringstream text(reports::junit_of({result("a.good", Verdict::verified, 1e-9),
                                               result("a.bad", Verdict::failed, 1.0),
                                               result("b.weak", Verdict::toothless, NAN)}));
    boost::property_tree::ptree xml;
    REQUIRE_NOTHROW(read_xml(text, xml));
    const auto& suite = xml.get_child("testsuite");
    CHECK(suite.get<int>("<xmlattr>.tests") == 3);
    CHECK(suite.get<int>("<xmlattr>.failures") == 2);
    std::vector<std::string> names, failed;
    for (const auto& [tag, node] : suite) {
        if (tag != "testcase") continue;
        names.push_back(node.get<std::string>("<xmlattr>.classname") + "." +
                        node.get<std::string>("<xmlattr>.name"));
        if (node.count("failure") > 0) {
            failed.push_back(node.get<std::string>("failure.<xmlattr>.message"));
            CHECK(node.get<std::string>("failure").find("a < b & \"c\"") == 0);
        }
    }
    CHECK(names == std::vector<std::string>{"a.good", "a.bad", "b.weak"});
    CHECK(failed == std::vector<std::string>{"failed", "toothless"});
}

TEST_CASE("of a child process both streams are kept, or stdout alone") {
    const std::vector<std::string> speaks{"sh", "-c", "echo complaint >&2; echo answer"};
    CHECK(reports::run_process(speaks)->output == "complaint\nanswer\n");
    CHECK(reports::run_process(speaks, reports::Streams::stdout_only)->output == "answer\n");
}

}  // namespace results_test
