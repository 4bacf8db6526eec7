#include "benchmarks/framework/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace benchmarks {

std::string factor_in_words(double factor) {
    if (!std::isfinite(factor) || factor <= 0.0) return "none";
    int exponent = static_cast<int>(std::floor(std::log10(factor)));
    double digits = std::round(factor * std::pow(10.0, 1 - exponent)) / 10.0;
    if (digits >= 10.0) digits /= 10.0, ++exponent;
    if (exponent >= -3 && exponent < 5)
        return fmt::format("{:.{}f}", digits * std::pow(10.0, exponent), std::max(0, 1 - exponent));
    static constexpr const char* superscripts[] = {"⁰", "¹", "²", "³", "⁴",
                                                   "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string power = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) power += superscripts[digit - '0'];
    return fmt::format("{:.1f}·10{}", digits, power);
}

}  // namespace benchmarks
