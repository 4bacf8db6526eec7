#include "reports/page/page.h"

#include "reports/charts/chart_json.h"
#include "verification/reports/page_example_test.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace page_test {
namespace {
using reports::Json;
using verification::small_report;

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}
}  // namespace

TEST_CASE("the page says what the report found, and needs nothing beside itself") {
    const auto charts = std::filesystem::temp_directory_path() / "plumbline_page_test";
    std::filesystem::remove_all(charts);
    const std::string page = reports::page_of(small_report(), charts);
    CHECK(count(page, "data:image/svg+xml;base64,") == 1);
    CHECK(page.find("alt=\"a falling line\"") != std::string::npos);
    CHECK(count(page, "<details>") >= 2);
    CHECK(page.find("<b>1 / 2</b>") != std::string::npos);
    CHECK(page.find("1 failed, 0 toothless") != std::string::npos);
    CHECK(page.find("&lt;script&gt;") != std::string::npos);
    for (const char* forbidden : {"<script", "http://", "https://", "url(", "@import", "{{"})
        CHECK(count(page, forbidden) == 0);
    CHECK(page == reports::page_of(small_report(), charts));
}

TEST_CASE("sections without content are left out") {
    const Json empty = {{"schema", "plumbline.report/1"},
                        {"provenance",
                         {{"version", "v1"},
                          {"started", ""},
                          {"processor", ""},
                          {"libraries", Json::object()},
                          {"seeds", Json::object()}}}};
    const std::string page =
        reports::page_of(empty, std::filesystem::temp_directory_path() / "plumbline_page_test");
    CHECK(count(page, "<section") == 2);  // the answers, and where the numbers come from
    CHECK(count(page, "<li class=\"tile") == 0);
}

TEST_CASE("a chart is the same after a round through JSON") {
    const Json json = small_report()["studies"][0]["chart"];
    CHECK(json_of(reports::chart_from(json), "s") == json);
}

}  // namespace page_test
