#include "verification/stability/map.h"

#include "solver/foundation/parallel.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace verification {

namespace {
std::vector<Map>& registered() {
    static std::vector<Map> all;
    return all;
}

Verdict verdict_on(const LineResult& line) {
    Verdict verdict = Verdict::verified;
    for (const BorderPoint& p : line.points) {
        if (std::isnan(p.measured))
            verdict = Verdict::inconclusive;
        else if (!line.line.ratio.holds(p.ratio()))
            return Verdict::failed;
    }
    return verdict;
}

/// The lines of a map with their curves and the points that are to be run.
std::vector<LineResult> lines_of(const Map& map, Effort effort) {
    std::vector<LineResult> lines;
    for (const Map::Line& line : map.lines) {
        LineResult result{line, {}, {}};
        for (const double x : map.curve_at) result.curve.push_back(line.theory(x));
        if (line.measured)
            for (const double x : effort == Effort::quick ? line.quick_at : line.full_at)
                result.points.push_back({x, line.theory(x), NAN});
        lines.push_back(std::move(result));
    }
    return lines;
}

/// Each run is small, so whole runs are shared out among the threads.
void measure(std::vector<LineResult>& lines, const std::function<void()>& between_points) {
    std::vector<std::pair<const Map::Line*, BorderPoint*>> runs;
    for (LineResult& line : lines)
        for (BorderPoint& point : line.points) runs.emplace_back(&line.line, &point);
    plumbline::parallel_for(
        runs.size(),
        [&](std::size_t k) {
            if (between_points) between_points();
            const auto& [line, point] = runs[k];
            point->measured = line->measured(point->x, point->theory);
        },
        1);
}
}  // namespace

double BorderPoint::ratio() const {
    if (theory == 0.0) return measured == 0.0 ? 1.0 : HUGE_VAL;
    return measured / theory;
}

MapResult run(const Map& map, Effort effort, const std::function<void()>& between_points) {
    const auto start = std::chrono::steady_clock::now();
    MapResult result{map, {}, 0.0, 0.0, {}, Verdict::verified};
    result.lines = lines_of(map, effort);
    measure(result.lines, between_points);
    for (LineResult& added : result.lines) {
        added.verdict = verdict_on(added);
        for (const BorderPoint& p : added.points)
            if (!std::isnan(p.measured))
                result.worst = std::max(result.worst, std::abs(p.ratio() - 1.0));
        if (result.verdict != Verdict::failed && added.verdict != Verdict::verified)
            result.verdict = added.verdict;
    }
    result.finding = map.finding(result);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

double bisected(const std::function<bool(double)>& breaks, double theory) {
    double whole = 0.5, broken = 1.5;
    if (breaks(whole * theory) || !breaks(broken * theory)) return NAN;
    while (broken - whole > 4e-3) {
        const double middle = 0.5 * (whole + broken);
        (breaks(middle * theory) ? broken : whole) = middle;
    }
    return 0.5 * (whole + broken) * theory;
}

const std::vector<Map>& maps() {
    static const std::vector<Map> all = [] {
        std::vector<Map> sorted = registered();
        std::ranges::stable_sort(sorted, {}, &Map::id);
        const auto twice = std::ranges::adjacent_find(sorted, {}, &Map::id);
        if (twice != sorted.end()) throw std::logic_error("registered twice: " + twice->id);
        return sorted;
    }();
    return all;
}
RegisterMap::RegisterMap(Map map) { registered().push_back(std::move(map)); }

}  // namespace verification
