// The forms in which results leave the program: JSON and JUnit.
#include "reports/json.h"
#include "reports/junit.h"

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

TEST_CASE("a claim in JSON has the promised members, and null for what is infinite") {
    const Json json = json_of(result("a.b", Verdict::verified, 1e-9));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"id", "source", "says", "measured", "bound", "verdict",
                                           "sabotaged", "seconds"});
    CHECK(json["bound"] == Json{{"low", nullptr}, {"high", 1e-6}, {"why", "rounding <= 1e-6"}});
    CHECK(json["sabotaged"] == Json{{"measured", 1.0}, {"caught", true}});
    CHECK(json_of(result("a.b", Verdict::failed, NAN))["measured"].is_null());
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

}  // namespace results_test
