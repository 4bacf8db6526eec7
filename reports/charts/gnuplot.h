#pragma once

#include "reports/charts/chart.h"

#include <filesystem>
#include <string>

namespace reports {

/// Colour, marker and dash of the series with this index: no two of the first 32 are alike.
struct SeriesStyle {
    std::string colour;
    int marker;  // gnuplot's point type
    std::string dash;
};
SeriesStyle style_of(int index);

/// The gnuplot script that draws `chart` as SVG and PNG. Throws InvalidInput if no point can be shown.
std::string gnuplot_script(const Chart& chart, const DrawnChart& files);

/// Runs the script. Throws std::runtime_error if gnuplot is missing or fails.
void draw_with_gnuplot(const Chart& chart, const DrawnChart& files);

}  // namespace reports
