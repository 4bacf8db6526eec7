#include "solver/io/base64.h"

#include <cstdint>

namespace plumbline {

namespace {
constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}
}  // namespace

std::string encode_base64(std::string_view bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t group =
            byte_at(bytes, i) << 16 | byte_at(bytes, i + 1) << 8 | byte_at(bytes, i + 2);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? alphabet[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::optional<std::string> decode_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t group = 0;
    int digits = 0, padding = 0;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        const std::size_t digit = c == '=' ? 0 : alphabet.find(c);
        if (digit == alphabet.npos || (padding > 0 && c != '=')) return std::nullopt;
        if (c == '=') ++padding;
        group = group << 6 | static_cast<std::uint32_t>(digit);
        if (++digits < 4) continue;
        if (padding > 2) return std::nullopt;
        for (int k = 0; k < 3 - padding; ++k)
            bytes += static_cast<char>(group >> (16 - 8 * k) & 255);
        group = 0, digits = 0, padding = 0;
    }
    if (digits > 0) return std::nullopt;
    return bytes;
}

}  // namespace plumbline
