#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reports {

/// One chart: its title is what it shows, its first ten colours can be told apart by everybody,
/// and marker and dash say the same as the colour. Colour, marker and dash follow from the index.
struct Chart {
    struct Axis {
        std::string label, unit;  // unit "1" for a ratio; empty: none is written
        bool log = false;
        std::vector<std::string> names = {};  // of the values 1, 2, ...; empty: numbers are shown
    };
    struct Range {
        double low, high;
    };
    struct Outline {
        std::vector<double> x, y;
    };
    struct Series {
        std::string name;
        std::vector<double> x, y;  // y not finite: the point stands on the upper rim
        std::vector<Range> x_range = {}, y_range = {};  // ends of the error bars; empty: no bars
        std::vector<double> failures =
            {};                         // x [unit of the axis] where the method failed: crossed out
        bool joined = true;             // by a line, in the order given
        std::optional<int> style = {};  // the index to take instead of its own
        static constexpr int black = 9;        // such an index
        std::vector<std::string> labels = {};  // beside each point; empty: none
        std::vector<Outline> outlines = {};    // closed curves around its points: their spread
        bool shaded = false;                   // what they enclose is grey
        bool markers = true;                   // on the line; without them it is a curve
        bool in_key = true;                    // the legend names it
        bool open = false;                     // markers are outlines
    };
    std::string finding;  // the title: "MLS-2 is 40x cheaper than SPH at 1e-4"
    Axis x, y;
    std::vector<Series> series;
    std::vector<double> slopes = {};  // triangles of these orders; both axes must be logarithmic
    std::string caption;
    std::string alt;      // for those who cannot see it
    std::string command;  // makes it again
};

/// The files of one chart; the CSV is its table twin, one row per point.
struct DrawnChart {
    std::filesystem::path svg, png, csv;
};

/// Writes NAME.svg, NAME.png (with gnuplot, as a child process) and NAME.csv into `directory`, which
/// is created. On a logarithmic axis, y <= 0 stands on the lower rim and x <= 0 is left out of the
/// picture; the CSV has every point as it is.
/// Throws InvalidInput if a series has lists of different lengths, if no point can be shown, or if values
/// of a logarithmic axis have names;
/// std::runtime_error if gnuplot is missing or fails, or a file cannot be written.
DrawnChart draw(const Chart& chart, const std::filesystem::path& directory,
                const std::string& name);

/// The table twin: header `series,x,x_low,x_high,y,y_low,y_high,status`, and `label` if a point has one;
/// 17 digits, RFC 4180.
std::string csv_of(const Chart& chart);

/// The value as the axis shows it: by the name of the nearest whole number if the axis has names.
std::string text_of(const Chart::Axis& axis, double value, int digits);

}  // namespace reports
