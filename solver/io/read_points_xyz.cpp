#include "solver/io/point_formats.h"

namespace plumbline {

namespace {
using Words = std::vector<std::string_view>;

/// The words of the next line that is neither blank nor a comment.
Words next_row(Lines& lines) {
    while (const auto line = lines.next())
        if (Words row = words(*line); !row.empty() && row[0][0] != '#') return row;
    return {};
}

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

std::vector<std::string> names_of(std::size_t numbers) {
    std::vector<std::string> names = {"x", "y", "z"};
    for (std::size_t c = 4; c <= numbers; ++c) names.push_back("column_" + std::to_string(c));
    return names;
}
}  // namespace

PointFile parse_xyz_points(const SourceText& text) {
    text.require_text();
    Lines lines(text.bytes());
    Words row = next_row(lines);
    std::string_view announced;
    if (row.size() == 1) {  // a molecule: the count, a comment, then one symbol and x y z per line
        announced = row[0];
        text.count(announced);
        lines.next();
        row = next_row(lines);
    }
    if (row.empty()) text.reject(text.bytes(), "lines \"x y z\"", "none");
    const std::size_t skipped = !announced.empty() && is_letter(row[0][0]) ? 1 : 0;
    const std::size_t size = row.size();
    if (size < skipped + 3) text.reject(row[0], "x, y and z", std::to_string(size) + " values");

    PointTable table(names_of(size - skipped));
    std::size_t n = 0;
    for (; !row.empty(); row = next_row(lines)) {
        if (row.size() != size)
            text.reject(row[std::min(size, row.size() - 1)],
                        std::to_string(size) + " values as in the first row",
                        std::to_string(row.size()));
        if (++n > most_points) text.reject(row[0], "at most 4294967294 points");
        table.begin_row();
        for (std::size_t c = skipped; c < size; ++c)
            table.add(c - skipped, text.finite_number(row[c]));
    }
    if (!announced.empty() && text.count(announced) != n)
        text.reject(announced, "the count of the points that follow, " + std::to_string(n));
    return table.take();
}

}  // namespace plumbline
