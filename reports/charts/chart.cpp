#include "reports/charts/chart.h"

#include "reports/charts/gnuplot.h"
#include "reports/files.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace reports {

namespace {
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

void check(const Chart& chart) {
    for (const Chart::Series& s : chart.series) {
        const std::size_t n = s.x.size();
        const auto fits = [n](std::size_t m) { return m == 0 || m == n; };
        if (s.y.size() != n || !fits(s.x_range.size()) || !fits(s.y_range.size()))
            throw plumbline::InvalidInput(fmt::format(
                "chart \"{}\", series \"{}\": expected as many y and ranges as x, found {} x, {} "
                "y, "
                "{} and {} ranges",
                chart.finding, s.name, n, s.y.size(), s.x_range.size(), s.y_range.size()));
    }
    if (!chart.slopes.empty() && !(chart.x.log && chart.y.log))
        throw plumbline::InvalidInput(fmt::format(
            "chart \"{}\": a slope triangle needs two logarithmic axes", chart.finding));
}
}  // namespace

std::string csv_of(const Chart& chart) {
    std::string out = "series,x,x_low,x_high,y,y_low,y_high,status\n";
    const auto value = [](double v) { return fmt::format("{:.17g}", v); };
    for (const Chart::Series& s : chart.series) {
        for (std::size_t k = 0; k < s.x.size(); ++k) {
            const Chart::Range xr = s.x_range.empty() ? Chart::Range{s.x[k], s.x[k]} : s.x_range[k];
            const Chart::Range yr = s.y_range.empty() ? Chart::Range{s.y[k], s.y[k]} : s.y_range[k];
            out += fmt::format("{},{},{},{},{},{},{},{}\n", quoted(s.name), value(s.x[k]),
                               value(xr.low), value(xr.high), value(s.y[k]), value(yr.low),
                               value(yr.high), std::isfinite(s.y[k]) ? "ok" : "failed");
        }
        for (const double x : s.failures)
            out += fmt::format("{},{},,,,,,failed\n", quoted(s.name), value(x));
    }
    return out;
}

DrawnChart draw(const Chart& chart, const std::filesystem::path& directory,
                const std::string& name) {
    check(chart);
    std::filesystem::create_directories(directory);
    const DrawnChart files{directory / (name + ".svg"), directory / (name + ".png"),
                           directory / (name + ".csv")};
    write_file(files.csv, csv_of(chart));
    draw_with_gnuplot(chart, files);
    return files;
}

}  // namespace reports
