#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// A file held in memory, and the place where something in it was found wrong.
/// Parts are views into bytes(), so that a message can say their line and column.
class SourceText {
public:
    /// Throws InvalidInput unless `path` is a readable, regular file that is not empty.
    static SourceText read(const std::filesystem::path& path);
    /// `name` begins every message. A byte order mark of UTF-8 at the start is dropped.
    SourceText(std::string name, std::string bytes);

    const std::string& name() const { return name_; }
    std::string_view bytes() const { return bytes_; }

    /// Throws InvalidInput "name:line:column: expected …, found …", where `part` begins;
    /// line and column count from 1, the column in characters.
    [[noreturn]] void reject(std::string_view part, const std::string& expected,
                             const std::string& found) const;
    /// As above, with `part` itself, quoted, as what was found.
    [[noreturn]] void reject(std::string_view part, const std::string& expected) const;
    /// Throws InvalidInput "name: place: expected …, found …", for what has no line.
    [[noreturn]] void reject_at(const std::string& place, const std::string& expected,
                                const std::string& found) const;

    /// Throws InvalidInput, naming the kind of file, if the bytes are not text.
    void require_text() const;
    /// `part`, blanks around it aside, as a number, whatever the locale; rejects anything else,
    /// infinities, NaN and what a double cannot hold.
    double finite_number(std::string_view part) const;
    /// As above for a whole number that is not negative.
    std::size_t count(std::string_view part) const;

private:
    std::string name_;
    std::string bytes_;
};

/// The lines of a text one after the other, without their ends (LF or CR LF).
class Lines {
public:
    explicit Lines(std::string_view text) : text_{text} {}
    /// The next line; empty at the end of the text.
    std::optional<std::string_view> next();
    /// What has not been handed out yet.
    std::string_view rest() const { return text_.substr(start_); }

private:
    std::string_view text_;
    std::size_t start_ = 0;
};

/// `text` in quotes, control characters escaped, shortened to what fits into a message.
std::string in_quotes(std::string_view text);
/// `text` without the blanks at both ends; still a view into the same bytes.
std::string_view trimmed(std::string_view text);
/// A whole number that is not negative, blanks around it aside; empty for any other text.
std::optional<std::size_t> parsed_count(std::string_view text);
/// The parts of `text` between blanks.
std::vector<std::string_view> words(std::string_view text);

}  // namespace plumbline
