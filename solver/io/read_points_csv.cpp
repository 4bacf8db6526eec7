#include "solver/io/csv.h"
#include "solver/io/point_formats.h"

#include <charconv>

namespace plumbline {

namespace {
bool is_number(std::string_view field) {
    double value = 0.0;
    field = trimmed(field);
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    return error == std::errc{} && end == field.data() + field.size();
}

/// A file that begins with a point would else be blamed for the names of its columns.
void reject_numbers_for_header(const SourceText& text) {
    text.require_text();
    Lines lines(text.bytes());
    while (const auto line = lines.next()) {
        const std::string_view first = trimmed(*line);
        if (first.empty() || first.starts_with('#')) continue;
        if (is_number(first.substr(0, first.find(','))))
            text.reject(
                first,
                "a header that names the columns before the first point: x,y or x,y,z, and a "
                "name for each further one, as in x,y,f",
                "the numbers " + in_quotes(first));
        return;
    }
}
}  // namespace

PointFile parse_csv_points(const SourceText& text) {
    reject_numbers_for_header(text);
    CsvRows rows(text);
    if (const std::string missing = missing_coordinate(rows.header()); !missing.empty())
        text.reject(rows.header_line(),
                    "a header x,y[,z][,further columns] with a column \"" + missing + "\"");
    PointTable table(rows.header());
    std::size_t n = 0;
    while (const auto* fields = rows.next()) {
        if (++n > most_points) text.reject(fields->front(), "at most 4294967294 points");
        table.begin_row();
        for (std::size_t c = 0; c < fields->size(); ++c)
            table.add(c, text.finite_number((*fields)[c]));
    }
    if (n == 0) text.reject(rows.header_line(), "at least one point below the header", "none");
    return table.take();
}

}  // namespace plumbline
