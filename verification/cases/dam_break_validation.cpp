#include "verification/cases/dam_break.h"
#include "verification/framework/validation.h"
#include "verification/reference_data/reference.h"

#include <numeric>

namespace dam_break_validation {
namespace {
using namespace verification;
using namespace plumbline;

/// Lengths run in the base a of the column, which is n² a high, and times in √(a/g); here a = 1 m.
constexpr double gravity = 9.81, last = 3.34, steady_from = 1.4;

Curve measured(const char* name, const char* time, const char* length, double until) {
    const Reference table(name);
    Curve curve;
    for (std::size_t k = 0; k < table.rows() && table[time][k] <= until; ++k)
        curve.x.push_back(table[time][k]), curve.y.push_back(table[length][k]);
    return curve;
}

double at(const Curve& curve, double x) {
    const auto above = std::ranges::upper_bound(curve.x, x);
    const auto k = static_cast<std::size_t>(above - curve.x.begin());
    const double share = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
    return std::lerp(curve.y[k - 1], curve.y[k], share);
}

/// The line through those samples of a curve by least squares.
struct Line {
    double slope, deviation, slope_deviation;
    Line(const Curve& curve, const std::vector<double>& samples) {
        const auto n = static_cast<double>(samples.size());
        const double mean_x = std::reduce(samples.begin(), samples.end()) / n;
        double mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
        for (const double x : samples) mean_y += at(curve, x) / n;
        for (const double x : samples) {
            const double dx = x - mean_x, dy = at(curve, x) - mean_y;
            xx += dx * dx, xy += dx * dy, yy += dy * dy;
        }
        slope = xy / xx;
        deviation = std::sqrt((yy - xy * slope) / (n - 2.0));
        slope_deviation = deviation / std::sqrt(xx);
    }
};
/// Where the curve is nearly straight; without its ends, so that it can be read there.
std::vector<double> steady(const Curve& table) {
    std::vector<double> samples;
    for (std::size_t k = 0; k + 1 < table.x.size(); ++k)
        if (table.x[k] >= steady_from) samples.push_back(table.x[k]);
    return samples;
}

/// Where the water stands at the wall behind it [m].
template <class Scene> double height_at_wall(const Scene& scene, double spacing) {
    const auto& x = scene.template get<Positions<2>>();
    const auto& wall = scene.template get<IsWall>();
    double highest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (wall[i] == 0 && x[i][0] < 2.0 * spacing) highest = std::max(highest, x[i][1]);
    return highest + 0.5 * spacing;
}

/// Z = x/a over T = t n √(g/a), and H = h/(n² a) over τ = t √(g/a).
struct Run {
    Curve front, height;
};
Run run(double n_squared, double spacing) {
    const double n = std::sqrt(n_squared), unit = 1.0 / std::sqrt(gravity);
    auto scene = scene_of<2, double>(
        DamBreak<2>{.tank = {6.0, 1.5 * n_squared}, .water = {1.0, n_squared}, .spacing = spacing});
    Run run{{{0.0}, {1.0}}, {{0.0}, {1.0}}};
    constexpr int samples = 67;
    for (int k = 1; k <= samples; ++k) {
        const double T = last * k / samples;
        advance_by_limits(scene, last / samples * unit / n);
        run.front.x.push_back(T);
        run.front.y.push_back(front<2>(scene) + 0.5 * spacing);
        run.height.x.push_back(T / n);
        run.height.y.push_back(height_at_wall(scene, spacing) / n_squared);
    }
    return run;
}

constexpr double release = 0.1;  // of T

/// A signal of the run, read at one time and by its slope.
struct Signal {
    Curve table;
    double time, release;
    std::string name;
    bool steady_speed;  // its slope says as much

    Line line() const { return {table, steady(table)}; }
    void add_numbers(const Curve& simulated, Validation::Observation& to) const {
        to.quantities.push_back(at(simulated, time));
        if (steady_speed) to.quantities.push_back(Line(simulated, steady(table)).slope);
        to.curves.push_back(simulated);
    }
    void add_quantities(Validation& to) const {
        to.quantities.push_back(
            {.name = name,
             .unit = "1",
             .measured = at(table, time),
             .u_data = 2.0 * line().deviation,
             .u_input = release * std::abs(line().slope),
             .why = "twice the scatter of the table about a line; a release at ± 0.1 in T"});
        if (!steady_speed) return;
        to.quantities.push_back(
            {.name = "speed of the " + name,
             .unit = "1",
             .measured = line().slope,
             .u_data = 2.0 * line().slope_deviation,
             .u_input = 0.0,
             .why =
                 "twice the deviation of the slope; the instant of the release does not matter"});
    }
};

Validation column(const char* id, const char* place, double n_squared, const Signal& front,
                  const std::optional<Signal>& height) {
    Validation v{
        .id = id,
        .source = {Paper::literature, place},
        .says = "A column of water is let go; its front Z = x/a runs along the floor",
        .what_is_run =
            "weakly compressible in the plane, Wendland C2 of support 2.6 spacings, artificial "
            "viscosity 0.1, walls of one layer of particles, a = 1 m, no gate",
        .spacing = {1.0 / 8, 1.0 / 12, 1.0 / 16, 1.0 / 24, 1.0 / 32, 1.0 / 48},
        .quantities = {},
        .panels = {{.name = "front",
                    .x_label = "T = t n √(g/a)",
                    .x_unit = "1",
                    .y_label = "Z = x/a",
                    .y_unit = "1",
                    .measured = front.table,
                    .low = {},
                    .high = {}}},
        .observe = [=](double spacing) {
            const Run observed = run(n_squared, spacing);
            Validation::Observation o;
            front.add_numbers(observed.front, o);
            if (height) height->add_numbers(observed.height, o);
            return o;
        }};
    front.add_quantities(v);
    if (!height) return v;
    height->add_quantities(v);
    v.says += ", what is left behind sinks";
    v.panels.push_back({.name = "height",
                        .x_label = "τ = t √(g/a)",
                        .x_unit = "1",
                        .y_label = "H = h/(n² a)",
                        .y_unit = "1",
                        .measured = height->table,
                        .low = {},
                        .high = {}});
    return v;
}

const RegisterValidation square{column(
    "dam_break_square", "Martin and Moyce 1952, Tables 2 and 6, n² = 1", 1.0,
    {measured("martin_moyce_1952_n2_1_front", "T", "Z", last), 2.65, release, "front", true}, {})};
const RegisterValidation tall{
    column("dam_break_tall", "Martin and Moyce 1952, Tables 2 and 6, n² = 2", 2.0,
           {measured("martin_moyce_1952_n2_2_front", "T", "Z", last), 2.65, release, "front", true},
           Signal{measured("martin_moyce_1952_n2_2_height", "tau", "H", last / std::numbers::sqrt2),
                  2.0, release / std::numbers::sqrt2, "height", false})};
}  // namespace
}  // namespace dam_break_validation
