#include "reports/charts/gnuplot.h"

#include "reports/files.h"
#include "reports/process.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace reports {

namespace {
/// The part of an axis that is shown; in decades when the axis is logarithmic.
struct Span {
    double low = HUGE_VAL, high = -HUGE_VAL;
    bool log = false;

    bool shows(double v) const { return std::isfinite(v) && (!log || v > 0.0); }
    void include(double v) {
        if (!shows(v)) return;
        const double at = log ? std::log10(v) : v;
        low = std::min(low, at), high = std::max(high, at);
    }
    void widen() {
        const double margin =
            std::max(0.06 * (high - low), log ? 0.1 : 1e-12 + 0.1 * std::abs(high));
        low -= margin, high += margin;
    }
    double at(double share) const {
        const double v = low + share * (high - low);
        return log ? std::pow(10.0, v) : v;
    }
};

struct Frame {
    Span x, y;
};

Frame frame_of(const Chart& chart) {
    Frame frame{{.log = chart.x.log}, {.log = chart.y.log}};
    for (const Chart::Series& s : chart.series) {
        for (const double v : s.x) frame.x.include(v);
        for (const double v : s.failures) frame.x.include(v);
        for (const double v : s.y) frame.y.include(v);
        for (const auto& r : s.x_range) frame.x.include(r.low), frame.x.include(r.high);
        for (const auto& r : s.y_range) frame.y.include(r.low), frame.y.include(r.high);
        for (const auto& outline : s.outlines) {
            for (const double v : outline.x) frame.x.include(v);
            for (const double v : outline.y) frame.y.include(v);
        }
    }
    for (const auto& [axis, span] : {std::pair{&chart.x, &frame.x}, std::pair{&chart.y, &frame.y}})
        if (!axis->names.empty())
            span->low = 0.7, span->high = static_cast<double>(axis->names.size()) + 0.3;
    if (frame.x.low > frame.x.high)
        throw plumbline::InvalidInput("chart \"" + chart.finding + "\": no point can be shown");
    if (frame.y.low > frame.y.high) frame.y.low = 0.0, frame.y.high = 1.0;  // only failures
    frame.x.widen();
    frame.y.widen();
    constexpr double share_of_label = 0.1;  // they stand to the right of their points
    if (std::ranges::any_of(chart.series, [](const auto& s) { return !s.labels.empty(); }))
        frame.x.high += share_of_label * (frame.x.high - frame.x.low);
    return frame;
}

std::string string_of(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out + '"';
}

std::string wrapped(const std::string& text, std::size_t width) {
    std::string out;
    std::size_t column = 0, start = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        const std::string word = text.substr(start, end - start);
        if (column > 0 && column + word.size() > width) out += "\\n", column = 0;
        if (column > 0) out += ' ';
        const std::string safe = string_of(word);
        out += safe.substr(1, safe.size() - 2);
        column += word.size() + 1;
        start = end + 1;
    }
    return '"' + out + '"';
}

std::string axis_of(char name, const Chart::Axis& axis, const Span& span) {
    const std::string unit = axis.unit.empty() ? "" : " [" + axis.unit + "]";
    std::string out = fmt::format("set {}label {} noenhanced\nset {}range [{:.9g}:{:.9g}]\n", name,
                                  string_of(axis.label + unit), name, span.at(0), span.at(1));
    if (!axis.names.empty()) {
        std::string ticks;
        for (std::size_t k = 0; k < axis.names.size(); ++k)
            ticks += fmt::format("{}{} {}", k == 0 ? "" : ", ", string_of(axis.names[k]), k + 1);
        out += fmt::format("set {}tics ({}) noenhanced\n", name, ticks);
    }
    if (axis.log) {
        // Decade ticks alone would leave a short axis without a number.
        const bool short_axis = span.high - span.low < 1.3;
        out += fmt::format("set logscale {} 10\n", name);
        out += short_axis ? fmt::format("set format {0} \"%g\"\nset {0}tics add (", name)
                          : fmt::format("set format {} \"10^{{%T}}\"\n", name);
        if (short_axis) {
            const int first = static_cast<int>(std::floor(span.low));
            std::string ticks;
            for (int decade = first; decade <= first + 2; ++decade)
                for (const int digit : {2, 5})
                    ticks += fmt::format("{}{:.3g}", ticks.empty() ? "" : ", ",
                                         digit * std::pow(10.0, decade));
            out += ticks + ")\n";
        }
    }
    return out;
}

/// A filled triangle over 12 % of the width whose hypotenuse has the slope `order`.
std::string triangle_of(const Frame& frame, double order, int number) {
    const double decades = frame.y.high - frame.y.low;
    const double width = std::min(0.12 * (frame.x.high - frame.x.low),
                                  0.3 * decades / std::max(std::abs(order), 1e-3));
    const double x1 = frame.x.high - (0.04 + 0.17 * number) * (frame.x.high - frame.x.low);
    const double x0 = x1 - width, y0 = frame.y.low + 0.05 * decades, y1 = y0 + order * width;
    const auto p = [](double v) { return fmt::format("{:.9g}", std::pow(10.0, v)); };
    return fmt::format(
        "set object {0} polygon from {1},{3} to {2},{3} to {2},{4} to {1},{3} fillstyle solid 0.15 "
        "border lc rgb '#555555' fillcolor rgb '#555555'\n"
        "set label {0} \"{5:.3g}\" at {2},{6} left offset 0.3,0 textcolor rgb '#333333'\n",
        number + 1, p(x0), p(x1), p(y0), p(y1), order, p(0.5 * (y0 + y1)));
}

/// The rows `x y x_low x_high y_low y_high label` of what lies inside, `x y` of what is on the rims and
/// of the outlines.
struct Blocks {
    std::string inside, rim, outlines;
};

Blocks blocks_of(const Chart::Series& s, const Frame& frame) {
    Blocks blocks;
    const auto on_rim = [&](double x, double share) {
        if (frame.x.shows(x)) blocks.rim += fmt::format("{:.9g} {:.9g}\n", x, frame.y.at(share));
    };
    for (std::size_t k = 0; k < s.x.size(); ++k) {
        if (!frame.x.shows(s.x[k])) continue;
        if (!frame.y.shows(s.y[k])) {
            on_rim(s.x[k], std::isfinite(s.y[k]) ? 0.0 : 1.0);
            blocks.inside += '\n';  // the line is broken here
            continue;
        }
        const auto end = [](double v, const Span& span) { return span.shows(v) ? v : span.at(0); };
        const Chart::Range xr = s.x_range.empty() ? Chart::Range{s.x[k], s.x[k]} : s.x_range[k];
        const Chart::Range yr = s.y_range.empty() ? Chart::Range{s.y[k], s.y[k]} : s.y_range[k];
        blocks.inside +=
            fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {}\n", s.x[k], s.y[k],
                        end(xr.low, frame.x), end(xr.high, frame.x), end(yr.low, frame.y),
                        end(yr.high, frame.y), string_of(s.labels.empty() ? "" : s.labels[k]));
    }
    for (const Chart::Outline& o : s.outlines) {
        for (std::size_t k = 0; k <= o.x.size() && !o.x.empty(); ++k)
            blocks.outlines +=
                fmt::format("{:.9g} {:.9g}\n", o.x[k % o.x.size()], o.y[k % o.x.size()]);
        blocks.outlines += '\n';
    }
    for (const double x : s.failures) on_rim(x, 1.0);
    return blocks;
}

constexpr int plus = 1, star = 3;  // of gnuplot

/// gnuplot has the outline of each filled marker before it.
int outline_of(int marker) { return marker == star ? plus : marker - 1; }

/// The parts of the plot command of one series.
std::vector<std::string> plots_of(const Chart::Series& s, int index, const Blocks& blocks) {
    SeriesStyle style = style_of(s.style.value_or(index));
    if (s.open) style.marker = outline_of(style.marker);
    const std::string line = fmt::format("lc rgb '{}' lw 1.8 dt {}", style.colour, style.dash);
    const double size = s.labels.empty() ? 1.1 : 1.8;
    const std::string point =
        fmt::format("lc rgb '{}' pt {} ps {}", style.colour, style.marker, size);
    const std::string bar = fmt::format("lc rgb '{}' lw 1 notitle", style.colour);
    const std::string title = s.in_key ? fmt::format("title {}", string_of(s.name)) : "notitle";
    const std::string data = fmt::format("$inside{}", index);
    std::vector<std::string> plots;
    if (blocks.inside.find_first_not_of('\n') != std::string::npos) {
        if (!s.x_range.empty())
            plots.push_back(data + " using 1:2:3:4 with xerrorbars pt 0 " + bar);
        if (!s.y_range.empty())
            plots.push_back(data + " using 1:2:5:6 with yerrorbars pt 0 " + bar);
        if (s.joined && !s.markers)
            plots.push_back(fmt::format("{} using 1:2 with lines {} {}", data, line, title));
        else
            plots.push_back(
                s.joined ? fmt::format("{} using 1:2 with linespoints {} pt {} ps 0.8 {}", data,
                                       line, style.marker, title)
                         : fmt::format("{} using 1:2 with points {} {}", data, point, title));
        if (!s.labels.empty())
            plots.push_back(data + " using 1:2:7 with labels left offset 1.2,0 noenhanced notitle");
    } else {
        plots.push_back(fmt::format("NaN with points {} {}", point, title));
    }
    if (!blocks.outlines.empty() && s.shaded)
        plots.insert(plots.begin(), fmt::format("$outlines{} using 1:2 with filledcurves closed lc "
                                                "rgb '#dddddd' fs solid noborder notitle",
                                                index));
    else if (!blocks.outlines.empty())
        plots.push_back(fmt::format("$outlines{} using 1:2 with lines lc rgb '{}' lw 1.2 notitle",
                                    index, style.colour));
    if (!blocks.rim.empty()) {
        const std::string rim = fmt::format("$rim{} using 1:2 with points", index);
        if (s.markers) plots.push_back(fmt::format("{} {} notitle", rim, point));
        plots.push_back(
            fmt::format("{} lc rgb '{}' pt 2 ps 1.9 lw 1.2 notitle", rim, style.colour));
    }
    return plots;
}

/// gnuplot names every picture "Gnuplot"; a reader's software should say what it shows.
void name_picture(const Chart& chart, const std::filesystem::path& svg) {
    const auto escaped = [](const std::string& text) {
        std::string out;
        for (const char c : text)
            out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
        return out;
    };
    std::string text = read_file(svg);
    const std::size_t title = text.find("<title>"), end = text.find("</desc>");
    if (title == std::string::npos || end == std::string::npos || end < title) return;
    text.replace(
        title, end - title,
        fmt::format("<title>{}</title>\n<desc>{}", escaped(chart.finding), escaped(chart.alt)));
    write_file(svg, text);
}
}  // namespace

SeriesStyle style_of(int index) {
    // Okabe and Ito's, black as the last, and between them three that are as far from all others, in CIELAB, as
    // those are from one another (16) for normal sight, protanopia, deuteranopia and tritanopia.
    static const std::array<const char*, 10> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#770000", "#330077",
                                                     "#77BB55", "#000000"};
    // Filled ones, whose outlines are free for another use, then a sign of lines.
    static const std::array<int, 7> markers{7, 5, 9, 13, 11, 15, star};
    static const std::array<const char*, 4> dashes{"1", "(9,4)", "(2,3)", "(12,3,2,3)"};
    const auto k = static_cast<std::size_t>(std::max(index, 0));
    return {colours[k % colours.size()], markers[k % markers.size()],
            dashes[(2 * k + k / markers.size()) % dashes.size()]};
}

/// Beside the plot, unless a long name would leave it no width; then below, on more paper.
struct Key {
    std::string place = "outside right top";
    std::size_t height = 0;
};
Key key_of(const Chart& chart) {
    std::size_t longest = 0;
    for (const Chart::Series& s : chart.series)
        if (s.in_key) longest = std::max(longest, s.name.size());
    if (longest <= 30) return {};
    return {"below maxcols 1", 20 * chart.series.size()};
}

std::string gnuplot_script(const Chart& chart, const DrawnChart& files) {
    const Frame frame = frame_of(chart);
    const Key key = key_of(chart);
    std::string script, plots;
    int index = 0;
    for (const Chart::Series& s : chart.series) {
        const Blocks blocks = blocks_of(s, frame);
        script += fmt::format(
            "$inside{0} << END\n{1}END\n$rim{0} << END\n{2}END\n$outlines{0} << END\n{3}END\n",
            index, blocks.inside, blocks.rim, blocks.outlines);
        for (const std::string& p : plots_of(s, index, blocks))
            plots += (plots.empty() ? "plot " : ", \\\n     ") + p;
        ++index;
    }
    script += "set encoding utf8\n";
    // A title proper would be centred on the plot, and clipped beside a wide key.
    script +=
        fmt::format("set label 1000 {} at screen 0.015, screen 0.955 left noenhanced font ',15'\n",
                    wrapped(chart.finding, 84));
    script += fmt::format(
        "set tmargin 4.5\nset key {} vertical Left reverse noenhanced samplen 3\n", key.place);
    script += "set grid lt 1 lc rgb '#cccccc' lw 0.8\nset border 3\n";
    script += "set tics nomirror\nset clip two\n";
    script += axis_of('x', chart.x, frame.x) + axis_of('y', chart.y, frame.y);
    int triangle = 0;
    for (const double order : chart.slopes) script += triangle_of(frame, order, triangle++);
    script += fmt::format(
        "set terminal svg size 900,{} dynamic font 'DejaVu Sans,13' background '#ffffff'\n",
        520 + key.height);
    script += fmt::format("set output {}\n{}\n", string_of(files.svg.string()), plots);
    script +=
        fmt::format("set terminal pngcairo size 1350,{} font 'DejaVu Sans,13' fontscale 1.5\n",
                    780 + key.height * 3 / 2);
    script += fmt::format("set output {}\nreplot\nunset output\n", string_of(files.png.string()));
    return script;
}

void draw_with_gnuplot(const Chart& chart, const DrawnChart& files) {
    std::filesystem::path script = files.svg;
    script.replace_extension(".gnuplot");
    write_file(script, gnuplot_script(chart, files));
    const auto result = run_process({"gnuplot", script.string()});
    if (!result)
        throw std::runtime_error(
            "gnuplot draws the charts and is not installed: sudo apt install gnuplot-nox");
    if (result->exit_code != 0)
        throw std::runtime_error(
            fmt::format("gnuplot failed on {}: {}", script.string(), result->output));
    std::filesystem::remove(script);
    name_picture(chart, files.svg);
}

}  // namespace reports
