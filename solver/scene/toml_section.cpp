#include "solver/scene/toml_section.h"

#include <cmath>
#include <sstream>

namespace plumbline {

namespace {
/// A value as the file has it, shortened; the kind of anything larger.
std::string shown(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array()) return "a list of " + std::to_string(node.as_array()->size());
    std::ostringstream text;
    if (const auto word = node.value_exact<std::string>())
        text << '"' << word->substr(0, 40) << '"';
    else if (const auto whole = node.value_exact<std::int64_t>())
        text << *whole;
    else if (const auto number = node.value_exact<double>())
        text << *number;
    else if (const auto flag = node.value_exact<bool>())
        text << (*flag ? "true" : "false");
    else
        text << "a date or time";
    return text.str();
}
}  // namespace

const toml::node* TomlSection::find(const std::string& key) {
    known_.insert(key);
    return table_.get(key);
}

bool TomlSection::has(const std::string& key) { return find(key) != nullptr; }

std::string TomlSection::place_of(const toml::node& node) const {
    const toml::source_position& at = node.source().begin;
    return file_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

void TomlSection::missing(const std::string& key, const std::string& expected) const {
    throw InvalidInput(place() + ": expected a key \"" + key + "\" in " + title() + ", " +
                       expected + ", found none");
}
void TomlSection::reject(const toml::node& node, const std::string& expected) const {
    throw InvalidInput(place_of(node) + ": expected " + expected + ", found " + shown(node));
}
void TomlSection::reject(const std::string& key, const std::string& expected,
                         const std::string& found) const {
    const toml::node* node = table_.get(key);
    throw InvalidInput((node ? place_of(*node) : place()) + ": expected " + expected + ", found " +
                       found);
}

double TomlSection::checked(const toml::node& node, Range range) const {
    const auto value = node.value<double>();
    if (node.is_boolean() || !value || !std::isfinite(*value) || !range.holds(*value))
        reject(node, range.says);
    return *value;
}

double TomlSection::number(const std::string& key, Range range) {
    const toml::node* node = find(key);
    if (!node) missing(key, range.says);
    return checked(*node, range);
}
double TomlSection::number(const std::string& key, Range range, double otherwise) {
    return optional_number(key, range).value_or(otherwise);
}
std::optional<double> TomlSection::optional_number(const std::string& key, Range range) {
    const toml::node* node = find(key);
    return node ? std::optional(checked(*node, range)) : std::nullopt;
}

int TomlSection::whole_number(const std::string& key, int low, int high,
                              std::optional<int> otherwise) {
    const std::string expected =
        "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    const toml::node* node = find(key);
    if (!node && otherwise) return *otherwise;
    if (!node) missing(key, expected);
    const auto value = node->value_exact<std::int64_t>();
    if (!value || *value < low || *value > high) reject(*node, expected);
    return static_cast<int>(*value);
}

bool TomlSection::flag(const std::string& key, bool otherwise) {
    const toml::node* node = find(key);
    if (!node) return otherwise;
    const auto value = node->value_exact<bool>();
    if (!value) reject(*node, "true or false");
    return *value;
}

std::string TomlSection::text(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) missing(key, "a text");
    const auto value = node->value_exact<std::string>();
    if (!value || value->empty()) reject(*node, "a text");
    return *value;
}

Vec<3> TomlSection::vector(const std::string& key, int dim, std::optional<Vec<3>> otherwise) {
    const std::string expected = "a list of " + std::to_string(dim) + " numbers";
    const toml::node* node = find(key);
    if (!node && otherwise) return *otherwise;
    if (!node) missing(key, expected);
    const toml::array* list = node->as_array();
    if (!list || list->size() != static_cast<std::size_t>(dim)) reject(*node, expected);
    Vec<3> v = Vec<3>::Zero();
    for (int d = 0; d < dim; ++d) v[d] = checked((*list)[static_cast<std::size_t>(d)], any_number);
    return v;
}

std::vector<std::string> TomlSection::words(const std::string& key,
                                            const std::vector<std::string>& allowed) {
    const toml::node* node = find(key);
    if (!node) return {};
    std::string expected = "a list of words among";
    for (const std::string& word : allowed) expected += " \"" + word + "\"";
    if (!node->is_array()) reject(*node, expected);
    std::vector<std::string> found;
    for (const toml::node& item : *node->as_array()) {
        const auto word = item.value_exact<std::string>();
        if (!word || std::find(allowed.begin(), allowed.end(), *word) == allowed.end())
            reject(item, expected);
        found.push_back(*word);
    }
    return found;
}

std::size_t TomlSection::choice_among(const std::string& key, const std::vector<const char*>& words,
                                      bool optional) {
    const toml::node* node = find(key);
    if (!node && optional) return 0;
    std::string expected;
    for (const char* word : words)
        expected.append(expected.empty() ? "one of \"" : ", \"").append(word).append("\"");
    if (!node) missing(key, expected);
    const auto found = node->value_exact<std::string>();
    for (std::size_t k = 0; k < words.size() && found; ++k)
        if (*found == words[k]) return k;
    reject(*node, expected);
}

std::optional<TomlSection> TomlSection::section(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_table()) reject(*node, "a table [" + key + "]");
    return TomlSection(*node->as_table(), file_, "[" + key + "]");
}

std::vector<TomlSection> TomlSection::sections(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return {};
    const std::string expected = "tables [[" + key + "]]";
    if (!node->is_array()) reject(*node, expected);
    std::vector<TomlSection> all;
    for (const toml::node& item : *node->as_array()) {
        if (!item.is_table()) reject(item, expected);
        all.emplace_back(*item.as_table(), file_, "[[" + key + "]]");
    }
    return all;
}

void TomlSection::refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
        if (known_.contains(std::string(key.str()))) continue;
        const toml::source_position& at = key.source().begin;
        std::string expected;
        for (const std::string& known : known_)
            expected.append(expected.empty() ? "one of the keys " : ", ").append(known);
        throw InvalidInput(file_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                           ": expected " + expected + " in " + title() + ", found \"" +
                           std::string(key.str()) + "\"");
    }
}

}  // namespace plumbline
