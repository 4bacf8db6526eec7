#pragma once

#include "solver/io/source_text.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// 17 significant digits, whatever the locale: reading the text gives the same bits again.
std::string digits17(double value);

/// Writes a header and then rows of as many fields; numbers with 17 digits, lines end with LF.
/// Text that has a comma, a quote or a line break is put into quotes, as RFC 4180 asks.
class CsvWriter {
public:
    CsvWriter(std::ostream& out, const std::vector<std::string>& header);

    CsvWriter& add(double value);
    CsvWriter& add(std::string_view text);
    /// Throws std::logic_error unless the row has as many fields as the header.
    void end_row();

private:
    void separate();

    std::ostream& out_;
    std::size_t columns_;
    std::size_t fields_ = 0;
};

/// The rows of a CSV text one after the other: blank lines and lines that begin with `#` are
/// skipped, quotes around a field are dropped, quotes within the fields of a row stay doubled.
class CsvRows {
public:
    /// Reads the header. Throws InvalidInput if there is none, or one name is empty or comes twice.
    explicit CsvRows(const SourceText& text);

    const std::vector<std::string>& header() const { return header_; }
    std::string_view header_line() const { return header_line_; }
    /// The fields of the next row, valid until the next call; null at the end of the text.
    /// Throws InvalidInput unless it has as many fields as the header.
    const std::vector<std::string_view>* next();

private:
    std::optional<std::string_view> next_line();

    const SourceText& text_;
    Lines lines_;
    std::string_view header_line_;
    std::vector<std::string> header_;
    std::vector<std::string_view> fields_;
};

/// A CSV of text and numbers, column by column.
class CsvTable {
public:
    /// Throws InvalidInput "file:line:column: expected …, found …" if it is not a table.
    static CsvTable read(const std::filesystem::path& path);

    std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
    const std::vector<std::string>& header() const { return header_; }
    /// Throws InvalidInput if there is no such column.
    const std::vector<std::string>& text(std::string_view column) const;
    /// As numbers; an empty field, and "nan", is NaN. Throws InvalidInput for any other text.
    std::vector<double> numbers(std::string_view column) const;

private:
    std::string name_;
    std::vector<std::string> header_;
    std::vector<std::vector<std::string>> columns_;
};

}  // namespace plumbline
