#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plumbline {

/// What a number may be, and the words for it.
struct Range {
    bool (*holds)(double);
    const char* says;
};
inline constexpr Range any_number{[](double) { return true; }, "a finite number"};
inline constexpr Range positive{[](double x) { return x > 0.0; }, "a number > 0"};
inline constexpr Range not_negative{[](double x) { return x >= 0.0; }, "a number >= 0"};
inline constexpr Range fraction{[](double x) { return x >= 0.0 && x <= 1.0; },
                                "a number from 0 to 1"};

/// A table of a TOML file: values by key, with a message that names file, line and column for
/// whatever is not as expected. Each key that is asked for counts as known.
class TomlSection {
public:
    TomlSection(const toml::table& table, std::string file, std::string name)
        : table_{table}, file_{std::move(file)}, name_{std::move(name)} {}

    bool has(const std::string& key);
    double number(const std::string& key, Range range);
    double number(const std::string& key, Range range, double otherwise);
    std::optional<double> optional_number(const std::string& key, Range range);
    int whole_number(const std::string& key, int low, int high, std::optional<int> otherwise = {});
    bool flag(const std::string& key, bool otherwise);
    std::string text(const std::string& key);
    /// `dim` finite numbers; zeros behind them.
    Vec<3> vector(const std::string& key, int dim, std::optional<Vec<3>> otherwise = {});
    std::vector<std::string> words(const std::string& key, const std::vector<std::string>& allowed);
    template <class Value> using Choices = std::initializer_list<std::pair<const char*, Value>>;
    /// The value that goes with the word of `key`; the first one if there is no such key and it is `optional`.
    template <class Value>
    Value choice(const std::string& key, Choices<Value> values, bool optional = false) {
        std::vector<const char*> words;
        for (const auto& [word, value] : values) words.push_back(word);
        return (values.begin() + choice_among(key, words, optional))->second;
    }

    /// A table inside this one; empty if there is none.
    std::optional<TomlSection> section(const std::string& key);
    /// The tables of an array [[key]].
    std::vector<TomlSection> sections(const std::string& key);

    /// Throws for a key that nobody asked for.
    void refuse_unknown_keys() const;
    /// Throws InvalidInput at the value of `key`, or where the table begins if it has none.
    [[noreturn]] void reject(const std::string& key, const std::string& expected,
                             const std::string& found) const;
    std::string place() const { return place_of(table_); }

private:
    std::size_t choice_among(const std::string& key, const std::vector<const char*>& words,
                             bool optional);
    const toml::node* find(const std::string& key);
    [[noreturn]] void missing(const std::string& key, const std::string& expected) const;
    [[noreturn]] void reject(const toml::node& node, const std::string& expected) const;
    double checked(const toml::node& node, Range range) const;
    std::string place_of(const toml::node& node) const;
    std::string title() const { return name_.empty() ? "the file" : name_; }

    const toml::table& table_;
    std::string file_, name_;
    std::set<std::string> known_;
};

}  // namespace plumbline
