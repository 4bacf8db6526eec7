#pragma once

#include "verification/framework/claim.h"
#include "verification/framework/study.h"

#include <functional>
#include <string>
#include <vector>

namespace verification {

/// Where something breaks: a border over one parameter, as the linear theory of the discrete scheme has it, and
/// as runs of the solver's own passes show it.
struct Map {
    std::string id;
    Source source;
    std::string says;
    struct Axis {
        std::string label, unit;
        bool log = false;
    };
    Axis x, y;
    std::vector<double> curve_at;  // x of the theory's curves
    struct Line {
        std::string name;
        std::function<double(double x)> theory;
        /// The same from runs; NaN where they could not tell. Empty for a rule that is shown, not tested.
        std::function<double(double x, double theory)> measured = {};
        std::vector<double> quick_at = {}, full_at = {};  // x of the runs
        Bound ratio = {};  // of measured to theory; its reason says why if it is wider than 2 %
    };
    std::vector<Line> lines;
    std::string what_is_run;  // for people: particles, steps, what counts as broken
    /// One sentence from the numbers, the title of the chart.
    std::function<std::string(const struct MapResult&)> finding;
    std::vector<std::string> tags = {};
};

/// Measured and theoretical border of one line at one place.
struct BorderPoint {
    double x, theory, measured;
    double ratio() const;  // 1 where both are 0
};
struct LineResult {
    Map::Line line;
    std::vector<double> curve;  // the theory at curve_at
    std::vector<BorderPoint> points;
    /// verified if all ratios are inside the bound; inconclusive if a border could not be told.
    Verdict verdict = Verdict::verified;
};
struct MapResult {
    Map map;
    std::vector<LineResult> lines;
    double worst = 0.0;  // largest |measured / theory − 1|
    double seconds = 0.0;
    std::string finding;
    Verdict verdict = Verdict::verified;
};

/// Shares the runs out among the threads; each is a function of its arguments alone. `between_points` may throw to end
/// it.
MapResult run(const Map& map, Effort effort, const std::function<void()>& between_points = {});

/// The border of `breaks(value)`, which holds above it: bisected from half to one and a half times `theory`, to
/// 0.4 % of it. NaN if it holds at the lower end already, or not even at the upper one.
double bisected(const std::function<bool(double)>& breaks, double theory);

/// All registered maps, by id.
const std::vector<Map>& maps();
/// `const RegisterMap r{Map{…}};` in a verification file.
struct RegisterMap {
    explicit RegisterMap(Map map);
};

}  // namespace verification
