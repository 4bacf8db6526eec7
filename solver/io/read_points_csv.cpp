#include "solver/io/csv.h"
#include "solver/io/point_formats.h"

namespace plumbline {

PointFile parse_csv_points(const SourceText& text) {
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
