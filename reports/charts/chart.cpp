#include "reports/charts/chart.h"

#include "reports/charts/gnuplot.h"
#include "reports/files.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <algorithm>
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
        if (s.y.size() != n || !fits(s.x_range.size()) || !fits(s.y_range.size()) ||
            !fits(s.labels.size()))
            throw plumbline::InvalidInput(fmt::format(
                "chart \"{}\", series \"{}\": expected as many y, ranges and labels as x, found "
                "{} x, {} y, {} and {} ranges, {} labels",
                chart.finding, s.name, n, s.y.size(), s.x_range.size(), s.y_range.size(),
                s.labels.size()));
        for (const Chart::Outline& o : s.outlines)
            if (o.x.size() != o.y.size())
                throw plumbline::InvalidInput(
                    fmt::format("chart \"{}\", series \"{}\": expected as many y as x in an "
                                "outline, found {} and {}",
                                chart.finding, s.name, o.y.size(), o.x.size()));
    }
    for (const Chart::Axis* axis : {&chart.x, &chart.y})
        if (axis->log && !axis->names.empty())
            throw plumbline::InvalidInput(fmt::format(
                "chart \"{}\": values of a logarithmic axis cannot have names", chart.finding));
    if (!chart.slopes.empty() && !(chart.x.log && chart.y.log))
        throw plumbline::InvalidInput(fmt::format(
            "chart \"{}\": a slope triangle needs two logarithmic axes", chart.finding));
}
}  // namespace

std::string csv_of(const Chart& chart) {
    const bool labelled =
        std::ranges::any_of(chart.series, [](const auto& s) { return !s.labels.empty(); });
    std::string out = "series,x,x_low,x_high,y,y_low,y_high,status";
    out += labelled ? ",label\n" : "\n";
    const auto value = [](double v) { return fmt::format("{:.17g}", v); };
    for (const Chart::Series& s : chart.series) {
        for (std::size_t k = 0; k < s.x.size(); ++k) {
            const Chart::Range xr = s.x_range.empty() ? Chart::Range{s.x[k], s.x[k]} : s.x_range[k];
            const Chart::Range yr = s.y_range.empty() ? Chart::Range{s.y[k], s.y[k]} : s.y_range[k];
            out += fmt::format("{},{},{},{},{},{},{},{}", quoted(s.name),
                               quoted(text_of(chart.x, s.x[k], 17)), value(xr.low), value(xr.high),
                               quoted(text_of(chart.y, s.y[k], 17)), value(yr.low), value(yr.high),
                               std::isfinite(s.y[k]) ? "ok" : "failed");
            if (labelled) out += "," + (s.labels.empty() ? "" : quoted(s.labels[k]));
            out += '\n';
        }
        for (const double x : s.failures)
            out += fmt::format("{},{},,,,,,failed{}\n", quoted(s.name),
                               quoted(text_of(chart.x, x, 17)), labelled ? "," : "");
    }
    return out;
}

std::string text_of(const Chart::Axis& axis, double value, int digits) {
    const double nearest = std::round(value);
    if (nearest >= 1.0 && nearest <= static_cast<double>(axis.names.size()))
        return axis.names[static_cast<std::size_t>(nearest) - 1];
    return fmt::format("{:.{}g}", value, digits);
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
