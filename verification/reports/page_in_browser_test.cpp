#include "reports/page/page.h"

#include "reports/files.h"
#include "reports/process.h"
#include "verification/reports/page_example_test.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace page_in_browser_test {
namespace {
using reports::Json;

/// Of its own for each test: they may run at the same time.
std::filesystem::path fresh_directory(const std::string& test) {
    const auto directory =
        std::filesystem::temp_directory_path() / ("plumbline_browser_test_" + test);
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
    return directory;
}

/// What a browser says of a page.
struct Visit {
    bool installed = true;
    std::string dom;
    std::size_t console_messages = 0, requests = 0;
};

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

/// What the page asked the network for. The browser asks for things of its own (its updates, the
/// time), which have no page as their origin.
std::size_t requests_in(const std::string& net_log) {
    return count(net_log, "\"initiator\":\"") - count(net_log, "\"initiator\":\"not an origin\"");
}

Visit visit(const std::filesystem::path& directory, const std::string& html) {
    const auto page = directory / "page.html", log = directory / "net_log.json";
    reports::write_file(page, html);
    const auto result = reports::run_process(
        {"chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--no-first-run", "--enable-logging=stderr", "--virtual-time-budget=5000",
         "--user-data-dir=" + (directory / "profile").string(), "--log-net-log=" + log.string(),
         "--dump-dom", "file://" + page.string()});
    if (!result) return {.installed = false, .dom = {}};
    return {.dom = result->output,
            .console_messages = count(result->output, ":CONSOLE"),
            .requests = requests_in(reports::read_file(log))};
}

/// The page forbids scripts, so the pictures are counted in a copy that allows one.
std::string with_picture_count(std::string html) {
    const auto policy = html.find("<meta http-equiv=\"Content-Security-Policy\"");
    html.erase(policy, html.find('>', policy) + 1 - policy);
    html.insert(html.find("</body>"),
                "<script>addEventListener('load', () => {"
                "const shown = [...document.images].filter(i => i.complete && i.naturalWidth > 0);"
                "document.title = `${shown.length} of ${document.images.length} pictures`;"
                "});</script>");
    return html;
}
}  // namespace

TEST_CASE("the page opens in a browser without an error, a request or a missing chart") {
    const auto directory = fresh_directory("page");
    const std::string html = reports::page_of(verification::small_report(), directory / "charts");
    const Visit plain = visit(directory, html);
    if (!plain.installed) {
        WARN("SKIPPED: chromium is not installed: sudo apt install chromium");
        return;
    }
    INFO(plain.dom);
    CHECK(plain.dom.find("Is the method right?") != std::string::npos);
    CHECK(plain.console_messages == 0);
    CHECK(plain.requests == 0);
    CHECK(visit(directory, with_picture_count(html)).dom.find("<title>1 of 1 pictures</title>") !=
          std::string::npos);
}

TEST_CASE("the browser test sees an error, a request and a missing chart") {
    const auto directory = fresh_directory("wrong_page");
    const Visit wrong =
        visit(directory, with_picture_count("<html><head><meta http-equiv=\"Content-Security-Policy"
                                            "\" content=\"x\"></head><body>"
                                            "<img src=\"http://127.0.0.1:9/chart.svg\">"
                                            "<script>undefined_function()</script></body></html>"));
    if (!wrong.installed) {
        WARN("SKIPPED: chromium is not installed: sudo apt install chromium");
        return;
    }
    CHECK(wrong.console_messages > 0);
    CHECK(wrong.requests > 0);
    CHECK(wrong.dom.find("<title>0 of 1 pictures</title>") != std::string::npos);
}

}  // namespace page_in_browser_test
