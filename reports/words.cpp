#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

std::string short_number(const Json& value) {
    if (value.is_number_integer()) return fmt::format("{}", value.get<long long>());
    if (value == "inf") return "∞";
    if (value == "-inf") return "−∞";
    return value.is_number() ? fmt::format("{:.3g}", value.get<double>()) : "none";
}

std::string in_words(const Json& numbers) {
    std::string text;
    for (const Json& n : numbers) text += (text.empty() ? "" : ", ") + short_number(n);
    return text;
}

std::string order_in_words(double order) {
    const std::string text = fmt::format("{:.1f}", order);
    return text == "-0.0" ? "0.0" : text;
}

std::string bound_in_words(const Json& bound) {
    const Json &low = bound.at("low"), &high = bound.at("high");
    if (!low.is_number()) return "≤ " + short_number(high);
    if (!high.is_number()) return "≥ " + short_number(low);
    if (low == high) return "= " + short_number(low);
    return fmt::format("in [{}, {}]", short_number(low), short_number(high));
}

std::string counted(std::size_t n, const std::string& noun) {
    return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string colour_class(const std::string& verdict) {
    if (verdict == "verified") return "ok";
    return verdict == "failed" || verdict == "toothless" || verdict == "saturated" ? "bad" : "open";
}

std::size_t count_verdict(const Json& results, const std::string& verdict) {
    return static_cast<std::size_t>(std::ranges::count_if(
        results, [&](const Json& r) { return r.value("verdict", "") == verdict; }));
}

}  // namespace reports
