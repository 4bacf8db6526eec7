#include "reports/fluid_frontier_report.h"

#include "benchmarks/framework/pareto.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

using benchmarks::FluidCandidate;
using benchmarks::FluidFrontier;

namespace {
std::string label_of(const FluidCandidate& c) { return fmt::format("{}, {}", c.method, c.kernel); }

Json json_of(const FluidCandidate& c) {
    return {{"method", c.method},
            {"kernel", c.kernel},
            {"resolution", c.resolution},
            {"support_in_spacings", number(c.support_in_spacings)},
            {"speed_of_sound", number(c.sound)},
            {"courant", number(c.courant)},
            {"error", number(c.error)},
            {"failure", c.failure},
            {"on_front", c.on_front},
            {"seconds", number(c.seconds)}};
}
/// RFC 4180: reasons of failures have commas.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}
}  // namespace

Json json_of(const FluidFrontier& frontier) {
    Json candidates = Json::array();
    for (const FluidCandidate& c : frontier.candidates) candidates.push_back(json_of(c));
    return {{"task", frontier.task},
            {"error", frontier.error},
            {"error_of", frontier.error_of},
            {"resolution_of", frontier.resolution_of},
            {"finding", frontier.finding},
            {"noise", number(frontier.noise)},
            {"candidates", std::move(candidates)}};
}

Chart chart_of(const FluidFrontier& frontier) {
    const auto failed = std::ranges::count_if(frontier.candidates, &FluidCandidate::failed);
    Chart chart{
        .finding = frontier.finding,
        .x = {"time of the run, one thread", "s", true},
        .y = {frontier.error, "1", true},
        .series = {},
        .caption = fmt::format("{}: {}. {} runs over {}, h/spacing, speed of sound and time step; "
                               "{} failed and stand on "
                               "the upper rim. One run each; two of the first differ by {:.0f} %.",
                               frontier.error, frontier.error_of, frontier.candidates.size(),
                               frontier.resolution_of, failed, 100.0 * frontier.noise),
        .alt = fmt::format("Error against time of every fluid method for {}; {}.", frontier.task,
                           frontier.finding),
        .command = "plumbline frontier " + frontier.task};
    for (const FluidCandidate& c : frontier.candidates) {
        auto series = std::ranges::find(chart.series, label_of(c), &Chart::Series::name);
        if (series == chart.series.end()) {
            chart.series.push_back(
                {.name = label_of(c), .x = {}, .y = {}, .joined = false, .style = {}});
            series = chart.series.end() - 1;
        }
        if (c.failed()) {
            series->failures.push_back(c.seconds);
        } else {
            series->x.push_back(c.seconds);
            series->y.push_back(c.error);
        }
    }
    Chart::Series front{
        .name = "Pareto front", .x = {}, .y = {}, .style = Chart::Series::black, .markers = false};
    for (const std::size_t k :
         benchmarks::pareto_front_of(frontier.candidates, &FluidCandidate::seconds)) {
        front.x.push_back(frontier.candidates[k].seconds);
        front.y.push_back(frontier.candidates[k].error);
    }
    chart.series.push_back(std::move(front));
    return chart;
}

std::string csv_of(const FluidFrontier& frontier) {
    std::string text =
        "method,kernel,resolution,support_in_spacings,speed_of_sound,courant,error,seconds,on_"
        "front,"
        "failure\n";
    for (const FluidCandidate& c : frontier.candidates)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", quoted(c.method), c.kernel,
                            c.resolution, c.support_in_spacings, c.sound, c.courant, c.error,
                            c.seconds, c.on_front, quoted(c.failure));
    return text;
}

}  // namespace reports
