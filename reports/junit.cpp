#include "reports/junit.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

using namespace verification;

namespace {
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

std::string case_of(const ClaimResult& r) {
    const auto dot = r.claim.id.find('.');
    std::string text = fmt::format(
        R"(  <testcase classname="{}" name="{}" time="{:.3f}")", escaped(r.claim.id.substr(0, dot)),
        escaped(r.claim.id.substr(std::min(dot, r.claim.id.size() - 1) + 1)), r.seconds);
    if (r.verdict == Verdict::verified) return text + "/>\n";
    const std::string measured =
        r.error.empty()
            ? fmt::format("measured {:.3e}, bound [{:.3e}, {:.3e}] because {}", r.measured,
                          r.claim.bound.low, r.claim.bound.high, r.claim.bound.why)
            : r.error;
    return text + fmt::format(">\n    <failure message=\"{}\">{}: {}</failure>\n  </testcase>\n",
                              name_of(r.verdict), escaped(r.claim.says), escaped(measured));
}
}  // namespace

std::string junit_of(const std::vector<ClaimResult>& results) {
    double seconds = 0.0;
    std::string cases;
    for (const ClaimResult& r : results) {
        seconds += r.seconds;
        cases += case_of(r);
    }
    const auto failures = std::ranges::count_if(
        results, [](const ClaimResult& r) { return r.verdict != Verdict::verified; });
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuite name=\"plumbline\" tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{:.3f}\">\n"
        "{}</testsuite>\n",
        results.size(), failures, seconds, cases);
}

}  // namespace reports
