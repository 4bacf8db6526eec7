#include "solver/io/source_text.h"

#include "solver/foundation/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <system_error>

namespace plumbline {

namespace {
constexpr std::string_view blanks = " \t\r\n\v\f";

struct Signature {
    std::string_view bytes, kind;
};
using namespace std::string_view_literals;
constexpr Signature signatures[] = {
    {"\x89PNG"sv, "a PNG image"},
    {"\xFF\xD8\xFF"sv, "a JPEG image"},
    {"GIF8"sv, "a GIF image"},
    {"%PDF-"sv, "a PDF document"},
    {"PK\x03\x04"sv, "a ZIP archive"},
    {"\x1F\x8B"sv, "a gzip archive"},
    {"\x7F"
     "ELF"sv,
     "an ELF program"},
    {"\x89HDF"sv, "an HDF5 file"},
    {"\xFF\xFE"sv, "text in UTF-16"},
    {"\xFE\xFF"sv, "text in UTF-16"},
    {"BZh"sv, "a bzip2 archive"},
    {"\xFD"
     "7zXZ"sv,
     "an xz archive"},
};

bool is_control(char c) { return (c >= 0 && c < ' ' && blanks.find(c) == blanks.npos) || c == 127; }
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

[[noreturn]] void reject_file(const std::string& name, const std::string& found) {
    throw InvalidInput(name + ": expected a readable file, found " + found);
}
}  // namespace

SourceText SourceText::read(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    const std::string name = path.string();
    if (!std::filesystem::exists(status)) reject_file(name, "none of that name");
    if (std::filesystem::is_directory(status)) reject_file(name, "a directory");
    std::ifstream file(path, std::ios::binary);
    if (!file) reject_file(name, std::strerror(errno));
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.empty()) reject_file(name, "an empty one");
    return {name, std::move(bytes)};
}

SourceText::SourceText(std::string name, std::string bytes)
    : name_{std::move(name)}, bytes_{std::move(bytes)} {
    if (bytes_.starts_with("\xEF\xBB\xBF")) bytes_.erase(0, 3);
}

void SourceText::reject(std::string_view part, const std::string& expected,
                        const std::string& found) const {
    const std::string_view before =
        bytes().substr(0, static_cast<std::size_t>(part.data() - bytes_.data()));
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::string_view in_line = before.substr(before.rfind('\n') + 1);
    const auto column = 1 + std::ranges::count_if(in_line, std::not_fn(continues_character));
    throw InvalidInput(name_ + ":" + std::to_string(line) + ":" + std::to_string(column) +
                       ": expected " + expected + ", found " + found);
}

void SourceText::reject(std::string_view part, const std::string& expected) const {
    reject(part, expected, in_quotes(part));
}

void SourceText::reject_at(const std::string& place, const std::string& expected,
                           const std::string& found) const {
    throw InvalidInput(name_ + ": " + place + ": expected " + expected + ", found " + found);
}

void SourceText::require_text() const {
    for (const Signature& s : signatures)
        if (bytes().starts_with(s.bytes)) reject(bytes(), "text", std::string(s.kind));
    const auto control = std::ranges::find_if(bytes_, is_control);
    if (control == bytes_.end()) return;
    const auto offset = static_cast<std::size_t>(control - bytes_.begin());
    reject(bytes().substr(offset), "text", "the control character " + in_quotes({&*control, 1}));
}

double SourceText::finite_number(std::string_view part) const {
    part = trimmed(part);
    std::string_view digits = part;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range && end == digits.data() + digits.size())
        reject(part, "a number that fits into a double");
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
        reject(part, "a finite number");
    return value;
}

std::size_t SourceText::count(std::string_view part) const {
    const auto value = parsed_count(part);
    if (!value) reject(trimmed(part), "a count (an integer that is not negative)");
    return *value;
}

std::optional<std::string_view> Lines::next() {
    if (start_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', start_), text_.size());
    std::string_view line = text_.substr(start_, end - start_);
    start_ = std::min(end + 1, text_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    constexpr std::string_view hexadecimal = "0123456789abcdef";
    std::string result = "\"";
    for (const char c : text.substr(0, longest)) {
        if (is_control(c) || c == '\n' || c == '\r' || c == '\t') {
            const auto byte = static_cast<unsigned char>(c);
            result.append("\\x").append({hexadecimal[byte / 16], hexadecimal[byte % 16]});
        } else {
            result += c;
        }
    }
    return result.append(text.size() > longest ? "…\"" : "\"");
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == text.npos) return text.substr(0, 0);
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<std::size_t> parsed_count(std::string_view text) {
    text = trimmed(text);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    std::size_t end = 0;
    for (std::size_t start; (start = text.find_first_not_of(blanks, end)) != text.npos;) {
        end = std::min(text.find_first_of(blanks, start), text.size());
        found.push_back(text.substr(start, end - start));
    }
    return found;
}

}  // namespace plumbline
