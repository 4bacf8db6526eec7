#include "solver/io/csv.h"

#include "solver/foundation/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumbline {

namespace {
/// Appends the fields of `line` to `fields`; `text` is for the message if a quote is never closed.
void split(const SourceText& text, std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    for (std::size_t start = 0;;) {
        const std::size_t first = line.find_first_not_of(" \t", start);
        if (first != line.npos && line[first] == '"') {
            std::size_t close = line.find('"', first + 1);
            while (close + 1 < line.size() && line[close] == '"' && line[close + 1] == '"')
                close = line.find('"', close + 2);
            if (close == line.npos) text.reject(line.substr(first), "a closing quote");
            fields.push_back(line.substr(first + 1, close - first - 1));
            start = line.find(',', close);
        } else {
            const std::size_t end = line.find(',', start);
            fields.push_back(trimmed(line.substr(start, end - start)));
            start = end;
        }
        if (start == line.npos) return;
        ++start;
    }
}

std::string counted(std::size_t n, const std::string& noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}
std::string without_doubled_quotes(std::string_view field) {
    std::string text;
    for (std::size_t i = 0; i < field.size(); ++i) {
        text += field[i];
        if (field.substr(i).starts_with("\"\"")) ++i;
    }
    return text;
}
}  // namespace

std::string digits17(double value) {
    char buffer[32];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 17);
    return {buffer, end};
}

CsvWriter::CsvWriter(std::ostream& out, const std::vector<std::string>& header)
    : out_{out}, columns_{header.size()} {
    for (const std::string& name : header) add(name);
    end_row();
}

CsvWriter& CsvWriter::add(double value) {
    separate();
    out_ << digits17(value);
    return *this;
}

CsvWriter& CsvWriter::add(std::string_view text) {
    separate();
    if (text.find_first_of(",\"\r\n") == text.npos) {
        out_ << text;
        return *this;
    }
    out_ << '"';
    for (const char c : text) out_ << (c == '"' ? "\"\"" : std::string(1, c));
    out_ << '"';
    return *this;
}

void CsvWriter::end_row() {
    if (fields_ != columns_)
        throw std::logic_error("CsvWriter: expected " + counted(columns_, "field") +
                               " in a row, found " + std::to_string(fields_));
    out_ << '\n';
    fields_ = 0;
}

void CsvWriter::separate() {
    if (fields_++ > 0) out_ << ',';
}

CsvRows::CsvRows(const SourceText& text) : text_{text}, lines_{text.bytes()} {
    text.require_text();
    const auto line = next_line();
    if (!line) text.reject(text.bytes(), "a header with the names of the columns", "none");
    header_line_ = *line;
    split(text, *line, fields_);
    for (const std::string_view name : fields_) {
        if (name.empty()) text.reject(name, "a name for each column", "an empty one");
        if (std::ranges::find(header_, name) != header_.end())
            text.reject(name, "each column once", in_quotes(name) + " twice");
        header_.push_back(without_doubled_quotes(name));
    }
}

const std::vector<std::string_view>* CsvRows::next() {
    const auto line = next_line();
    if (!line) return nullptr;
    split(text_, *line, fields_);
    if (fields_.size() < header_.size())
        text_.reject(line->substr(line->size()),
                     counted(header_.size(), "field") + " as in the header",
                     std::to_string(fields_.size()) + " in " + in_quotes(*line));
    if (fields_.size() > header_.size())
        text_.reject(fields_[header_.size()],
                     counted(header_.size(), "field") + " as in the header",
                     std::to_string(fields_.size()) + " in " + in_quotes(*line));
    return &fields_;
}

std::optional<std::string_view> CsvRows::next_line() {
    while (const auto line = lines_.next())
        if (const auto content = trimmed(*line); !content.empty() && content[0] != '#') return line;
    return std::nullopt;
}

CsvTable CsvTable::read(const std::filesystem::path& path) {
    const SourceText text = SourceText::read(path);
    CsvRows rows(text);
    CsvTable table;
    table.name_ = text.name();
    table.header_ = rows.header();
    table.columns_.resize(table.header_.size());
    while (const auto* fields = rows.next())
        for (std::size_t c = 0; c < fields->size(); ++c)
            table.columns_[c].push_back(without_doubled_quotes((*fields)[c]));
    return table;
}

const std::vector<std::string>& CsvTable::text(std::string_view column) const {
    const auto found = std::ranges::find(header_, column);
    if (found == header_.end())
        throw InvalidInput(name_ + ": expected a column \"" + std::string(column) +
                           "\", found none of that name");
    return columns_[static_cast<std::size_t>(found - header_.begin())];
}

std::vector<double> CsvTable::numbers(std::string_view column) const {
    std::vector<double> values;
    for (const std::string& field : text(column)) {
        const bool missing = field.empty() || field == "nan";
        const SourceText source(name_ + ": column " + std::string(column) + ", row " +
                                    std::to_string(values.size() + 1),
                                field);
        values.push_back(missing ? std::numeric_limits<double>::quiet_NaN()
                                 : source.finite_number(source.bytes()));
    }
    return values;
}

}  // namespace plumbline
