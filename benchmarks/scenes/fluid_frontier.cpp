#include "benchmarks/scenes/fluid_frontier.h"

#include "benchmarks/framework/pareto.h"
#include "benchmarks/framework/timing.h"
#include "benchmarks/scenes/fluid_tasks.h"
#include "solver/foundation/errors.h"
#include "solver/foundation/parallel.h"

#include <fmt/format.h>

#include <algorithm>

namespace benchmarks {

namespace {
using plumbline::set_thread_count;
using plumbline::thread_count;
using verification::Effort;

const FluidTask& fluid_task_of(const std::string& name) {
    for (const FluidTask& task : all_fluid_tasks())
        if (task.name == name) return task;
    std::string expected;
    for (const FluidTask& task : all_fluid_tasks()) expected += " " + task.name;
    throw plumbline::InvalidInput("frontier: expected a fluid of" + expected + ", found \"" + name +
                                  "\"");
}

class OneThread {
public:
    OneThread() { set_thread_count(1); }
    ~OneThread() { set_thread_count(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    int before_ = thread_count();
};

/// What a scene throws when it blows up is a result, not an error.
void measure(const FluidTask& task, FluidCandidate& c) {
    c.seconds = seconds_of([&] {
        try {
            c.error = task.run(c);
            if (std::isnan(c.error)) c.error = HUGE_VAL, c.failure = "not a number";
        } catch (const plumbline::InvalidInput& blown_up) {
            c.failure = blown_up.what();
        }
    });
    if (c.failure.empty() && c.failed()) c.failure = "an error of 1 or more";
}

const FluidCandidate* best_of(const std::vector<FluidCandidate>& candidates, bool incompressible) {
    const FluidCandidate* best = nullptr;
    for (const FluidCandidate& c : candidates)
        if (!c.failed() && (c.sound == 0.0) == incompressible && (!best || c.error < best->error))
            best = &c;
    return best;
}

std::string finding_of(const FluidFrontier& frontier) {
    const FluidCandidate* best = nullptr;
    for (const FluidCandidate& c : frontier.candidates)
        if (!c.failed() && (!best || c.error < best->error)) best = &c;
    if (!best) return "no method gave an answer";
    std::string text = fmt::format("{} reaches {:.1f} % in {:.2g} s", best->method,
                                   100.0 * best->error, best->seconds);
    const bool other_kind = best->sound != 0.0;
    if (const FluidCandidate* other = best_of(frontier.candidates, other_kind))
        text += fmt::format(", {} {:.1f} % in {:.2g} s", other->method, 100.0 * other->error,
                            other->seconds);
    const auto failed = std::ranges::count_if(frontier.candidates, &FluidCandidate::failed);
    return text + fmt::format("; {} of {} fail", failed, frontier.candidates.size());
}
}  // namespace

const std::vector<std::string>& fluid_tasks() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const FluidTask& task : all_fluid_tasks()) all.push_back(task.name);
        return all;
    }();
    return names;
}

std::vector<std::string> fluid_methods(const std::string& task) {
    std::vector<std::string> names;
    for (const FluidCandidate& c : fluid_task_of(task).variants)
        if (std::ranges::find(names, c.method) == names.end()) names.push_back(c.method);
    return names;
}

FluidFrontier measure_fluids(const std::string& name, Effort effort,
                             const std::function<void()>& between_runs) {
    const OneThread one_thread;
    const FluidTask& task = fluid_task_of(name);
    FluidFrontier frontier{task.name, task.error, task.error_of, task.resolution_of, {}, 0.0, {}};
    for (const int resolution : effort == Effort::quick ? task.quick_resolutions : task.resolutions)
        for (FluidCandidate c : task.variants) {
            if (between_runs) between_runs();
            c.resolution = resolution;
            measure(task, c);
            frontier.candidates.push_back(std::move(c));
        }
    FluidCandidate again = frontier.candidates.front();
    measure(task, again);
    const double a = frontier.candidates.front().seconds, b = again.seconds;
    frontier.noise = std::abs(a - b) / std::min(a, b);
    for (const std::size_t k : pareto_front_of(frontier.candidates, &FluidCandidate::seconds))
        frontier.candidates[k].on_front = true;
    frontier.finding = finding_of(frontier);
    return frontier;
}

}  // namespace benchmarks
