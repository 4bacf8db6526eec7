#include "reports/run/frame_picture.h"

#include "reports/files.h"
#include "reports/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reports {

namespace {
using plumbline::SceneFile;
using plumbline::Snapshot;

struct Dot {
    double across, up, depth, value;
};

/// Where a point appears; in space along an oblique line of sight, x to the right, the last axis up.
Dot seen(std::span<const double> x, int dim, std::size_t i) {
    const double* p = x.data() + i * static_cast<std::size_t>(dim);
    if (dim == 2) return {p[0], p[1], 0.0, 0.0};
    const double turned = 0.42, raised = 0.35;  // [rad]
    const double back = std::sin(turned) * p[0] + std::cos(turned) * p[1];
    return {std::cos(turned) * p[0] - std::sin(turned) * p[1],
            std::cos(raised) * p[2] + std::sin(raised) * back,
            std::cos(raised) * back - std::sin(raised) * p[2], 0.0};
}

struct Colours {
    std::string label;
    double low, high;
};
Colours colours_of(const SceneFile& scene) {
    const double fastest = 0.1 * scene.speed_of_sound;
    if (scene.picture == "pressure")
        return {scene.dim == 3 ? "pressure [Pa]" : "pressure [N/m]", 0.0,
                scene.density * fastest * fastest};
    if (scene.picture == "density")
        return {scene.dim == 3 ? "density [kg/m3]" : "density [kg/m2]", 0.99 * scene.density,
                1.01 * scene.density};
    return {"speed [m/s]", 0.0, fastest};
}
double value_of(const SceneFile& scene, const Snapshot& s, std::size_t i) {
    if (scene.picture == "pressure") return s.p[i];
    if (scene.picture == "density") return s.rho[i];
    double squares = 0.0;
    const auto dim = static_cast<std::size_t>(s.dim);
    for (std::size_t d = 0; d < dim; ++d) squares += s.v[i * dim + d] * s.v[i * dim + d];
    return std::sqrt(squares);
}

std::vector<Dot> dots_of(const SceneFile& scene, const Snapshot& s) {
    std::vector<Dot> dots;
    for (std::size_t i = 0; i < s.size(); ++i) {
        dots.push_back(seen(s.x, s.dim, i));
        dots.back().value = value_of(scene, s, i);
    }
    std::ranges::stable_sort(dots, std::greater{}, &Dot::depth);
    return dots;
}

struct View {
    double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;
    void include(const Dot& dot) {
        left = std::min(left, dot.across), right = std::max(right, dot.across);
        bottom = std::min(bottom, dot.up), top = std::max(top, dot.up);
    }
};

std::string script_of(const std::filesystem::path& png, const SceneFile& scene, double time,
                      const Snapshot& s) {
    View view;
    std::string walls = "$walls << END\n", bodies, fluid = "$fluid << END\n";
    for (std::size_t i = 0; i * static_cast<std::size_t>(s.dim) < s.ghosts.size(); ++i) {
        const Dot dot = seen(s.ghosts, s.dim, i);
        view.include(dot);
        const bool in_body = !s.body_of_ghost.empty() && s.body_of_ghost[i] < s.bodies.size();
        (in_body ? bodies : walls) += fmt::format("{:.6g} {:.6g}\n", dot.across, dot.up);
    }
    const bool walled = walls.find('\n') + 1 < walls.size();
    for (const Dot& dot : dots_of(scene, s)) {
        if (!walled) view.include(dot);
        fluid += fmt::format("{:.6g} {:.6g} {:.6g}\n", dot.across, dot.up, dot.value);
    }
    const double margin = 2.0 * scene.spacing;
    const double width = view.right - view.left + 2.0 * margin;
    const double height = view.top - view.bottom + 2.0 * margin;
    // The plot is 800 pixels wide or 600 high; a point of size 1 is about 8 pixels wide.
    const double scale = std::min(800.0 / width, 600.0 / height);
    const double size = std::max(0.15, scene.spacing * scale / 8.0);
    const Colours colours = colours_of(scene);
    std::string title;
    for (const char c : scene.title) title += c == '"' || c == '\\' || c == '\n' ? '\'' : c;
    std::string script = walls + "END\n" + fluid + "END\n";
    if (!bodies.empty()) script += "$bodies << END\n" + bodies + "END\n";
    script += fmt::format(
        "set encoding utf8\nset terminal pngcairo size {:.0f},{:.0f} font 'DejaVu Sans,12'\n"
        "set output '{}'\nset title \"{}, t = {:.4g} s\" noenhanced\nset size ratio -1\n",
        std::max(460.0, width * scale + 210.0), std::max(260.0, height * scale + 110.0),
        png.string(), title, time);
    script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", view.left - margin,
                          view.right + margin, view.bottom - margin, view.top + margin);
    script +=
        s.dim == 2 ? "set xlabel 'x [m]'\nset ylabel 'y [m]'\n" : "unset tics\nunset border\n";
    script += fmt::format(
        "set cblabel '{}'\nset cbrange [{}:{}]\nset cbtics\nset key off\nset "
        "palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n",
        colours.label, colours.low, colours.high);
    std::string plot = "plot ";
    if (walled)
        plot += s.dim == 2 ? fmt::format(
                                 "$walls using 1:2 with points pt 7 ps {} lc rgb '#bbbbbb', ", size)
                           : fmt::format("$walls using 1:2 with points pt 0 lc rgb '#cccccc', ");
    plot += fmt::format("$fluid using 1:2:3 with points pt 7 ps {} palette", size);
    if (!bodies.empty())
        plot += fmt::format(", $bodies using 1:2 with points pt 7 ps {} lc rgb '#cc4c02'", size);
    return script + plot + "\n";
}
}  // namespace

void draw_frame(const std::filesystem::path& png, const SceneFile& scene, double time,
                const Snapshot& particles) {
    if (png.string().find('\'') != std::string::npos)
        throw std::runtime_error("gnuplot cannot write to a path with a quote: " + png.string());
    std::filesystem::path script = png;
    script.replace_extension(".gnuplot");
    write_file(script, script_of(png, scene, time, particles));
    const auto result = run_process({"gnuplot", script.string()});
    std::filesystem::remove(script);
    if (!result)
        throw std::runtime_error(
            "gnuplot draws the frames and is not installed (sudo apt install gnuplot-nox); without "
            "them: picture = \"none\"");
    if (result->exit_code != 0)
        throw std::runtime_error(
            fmt::format("gnuplot failed on {}: {}", png.string(), result->output));
}

}  // namespace reports
