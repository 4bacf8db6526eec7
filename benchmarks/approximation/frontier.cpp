#include "benchmarks/approximation/frontier.h"

#include "benchmarks/approximation/frontier_methods.h"
#include "solver/foundation/parallel.h"
#include "solver/kernels/all_kernels.h"
#include "verification/framework/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Effort;
using verification::Quantity;

struct Plan {
    std::vector<std::string_view> kernels;
    std::vector<double> supports;  // in spacings; 1.5 is too small for most methods
    /// Likewise, for SPH and its kin alone: the wider the support, the more of the noise of a disordered sum
    /// averages out. MLS has no such noise: there it would cost more for a larger error.
    std::vector<double> wide_supports;
    std::vector<int> samples_per_metre;
    std::size_t places;
    int rounds;
    double seconds;  // after which a situation has no further round

    bool is_wide(double support) const { return support > supports.back(); }
};

Plan plan_of(int dim, Effort effort) {
    const std::vector<std::string_view> three{"poly6", "cubic_spline", "wendland_c4"};
    if (effort == Effort::quick)
        return dim == 2 ? Plan{three, {1.5, 2.0, 2.5, 3.5}, {10.0}, {20, 40, 80, 160}, 400, 9, 0.2}
                        : Plan{three, {1.5, 2.0, 2.5, 3.0}, {6.0}, {8, 12, 18, 27}, 200, 7, 0.2};
    if (dim == 2)
        return {AllKernels::names<2>(),
                {1.5, 2.0, 2.5, 3.0, 3.5, 4.5},
                {6.0, 8.0, 10.0},
                {20, 40, 80, 160, 320},
                2000,
                25,
                2.0};
    return {AllKernels::names<3>(),
            {1.5, 2.0, 2.5, 3.0, 3.5},
            {5.0, 7.0, 10.0},
            {8, 12, 18, 27, 40},
            1000,
            15,
            2.0};
}

/// One thread, so that methods are compared and not schedules; what was set is put back.
class OneThread {
public:
    OneThread() { set_thread_count(1); }
    ~OneThread() { set_thread_count(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    int before_ = thread_count();
};

struct Errors {
    double rms, largest;
};
template <int Dim>
double squared_error(Quantity quantity, const Vec<Dim>& x, const double* answer) {
    using Exact = verification::TestFunction<Dim>;
    switch (quantity) {
        case Quantity::value:
            return std::pow(*answer - Exact::value(x), 2);
        case Quantity::gradient:
            return (Eigen::Map<const Vec<Dim>>(answer) - Exact::gradient(x)).squaredNorm();
        case Quantity::laplacian:
            break;
    }
    return std::pow(*answer - Exact::laplacian(x), 2);
}
template <int Dim>
Errors errors_of(const Situation<Dim>& s, Quantity quantity, std::span<const double> answers) {
    double sum = 0, largest = 0;
    for (std::size_t k = 0; k < s.places.size(); ++k) {
        const double square =
            squared_error(quantity, s.places[k], &answers[k * components_of<Dim>(quantity)]);
        sum += square;
        largest = std::max(largest, square);
    }
    const double rms = std::sqrt(sum / static_cast<double>(s.places.size()));
    return {rms, std::isnan(rms) ? rms : std::sqrt(largest)};
}

/// What one method takes, run by run.
struct Runs {
    std::vector<double> evaluation, precomputation, application;
};

Timing per_place(const std::vector<double>& seconds, std::size_t places) {
    const Timing all = summarise(seconds);
    const auto n = static_cast<double>(places);
    return {all.median_s / n, all.mad_s / n};
}

void time_once(const PreparedMethod& method, std::vector<double>& out, Runs& runs) {
    runs.evaluation.push_back(seconds_of([&] { method.evaluate(out); }));
    if (!method.precompute) return;
    runs.precomputation.push_back(seconds_of(method.precompute));
    // Lagrangian use applies many times: what is timed is not the first time.
    constexpr int applications = 10;
    method.apply(out);
    runs.application.push_back(seconds_of([&] {
                                   for (int k = 0; k < applications; ++k) method.apply(out);
                               }) /
                               applications);
}

struct Measured {
    std::vector<Candidate> candidates;
    std::vector<double> differences;  // of the A/A comparison, relative
};

/// All methods on one situation, in turns, every other round backwards. The first method runs a
/// second time, under no name: what its two medians differ by is noise.
template <int Dim>
Measured measure_situation(const Situation<Dim>& s, Quantity quantity, const Plan& plan) {
    std::vector<PreparedMethod> methods = sph_methods(s, quantity);
    if (!plan.is_wide(s.support_in_spacings))
        for (PreparedMethod& method : mls_methods(s, quantity))
            methods.push_back(std::move(method));
    const SampleCosts costs = s.sample_costs(3);
    std::vector<double> out(s.places.size() * components_of<Dim>(quantity));

    Measured result;
    for (const PreparedMethod& method : methods) {
        Candidate c{};
        c.method = method.name;
        c.kernel = s.kernel;
        c.dim = Dim;
        c.support_in_spacings = s.support_in_spacings;
        c.samples_per_metre = static_cast<int>(std::lround(1.0 / s.spacing));
        c.places = s.places.size();
        c.mean_neighbours =
            static_cast<double>(s.rows.indices.size()) / static_cast<double>(c.places);
        c.failures = method.evaluate(out);
        const Errors errors = errors_of(s, quantity, out);
        c.error = errors.rms;
        c.largest_error = errors.largest;
        c.search_s = costs.search_s;
        c.volumes_s = method.reads_volumes ? costs.volumes_s : 0.0;
        result.candidates.push_back(std::move(c));
    }

    std::vector<std::size_t> order{methods.size()};  // the second run of the first method
    for (std::size_t k = 0; k < methods.size(); ++k) order.push_back(k);
    std::vector<Runs> runs(methods.size() + 1);
    double seconds = 0.0;
    for (int round = 0; round < plan.rounds; ++round) {
        if (round >= static_cast<int>(least_rounds) && seconds > plan.seconds) break;
        seconds += seconds_of([&] {
            for (const std::size_t k : order) time_once(methods[k % methods.size()], out, runs[k]);
        });
        std::ranges::reverse(order);
    }
    for (std::size_t k = 0; k < methods.size(); ++k) {
        Candidate& c = result.candidates[k];
        c.evaluation = per_place(runs[k].evaluation, c.places);
        if (runs[k].application.empty()) continue;
        c.precomputation = per_place(runs[k].precomputation, c.places);
        c.application = per_place(runs[k].application, c.places);
    }
    const double a = summarise(runs.front().evaluation).median_s;
    const double again = summarise(runs.back().evaluation).median_s;
    result.differences.push_back(std::abs(a - again) / std::min(a, again));
    return result;
}

Trend trend_of(const std::vector<const Candidate*>& levels) {
    std::vector<double> spacing;
    std::vector<std::vector<double>> errors;
    for (const Candidate* c : levels) {
        if (c->failed()) return Trend::unclear;
        spacing.push_back(1.0 / c->samples_per_metre);
        errors.push_back({c->error});
    }
    const verification::Study::Series falling{
        "", verification::at_least(0.25, "an error that falls more slowly does not fall")};
    const auto fit = verification::fit_power_law(spacing, errors, 1.0);
    switch (verification::judge(falling, fit)) {
        case verification::Verdict::verified:
            return Trend::falls;
        case verification::Verdict::saturated:
            return Trend::saturated;
        case verification::Verdict::failed:
            return Trend::grows;
        default:
            return Trend::unclear;
    }
}

void set_trends(std::vector<Candidate>& candidates) {
    using Curve = std::tuple<std::string, std::string, double>;
    std::map<Curve, std::vector<const Candidate*>> curves;
    for (const Candidate& c : candidates)
        curves[{c.method, c.kernel, c.support_in_spacings}].push_back(&c);
    for (Candidate& c : candidates)
        c.trend = trend_of(curves.at({c.method, c.kernel, c.support_in_spacings}));
}

/// The value below which 95 % of them are.
double most_of(std::vector<double> values) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1))];
}

/// All situations, one after the other, and what their A/A comparisons differ by.
template <int Dim>
Measured measure_situations(Quantity quantity, const Plan& plan,
                            const std::function<void(double)>& between_steps) {
    std::vector<double> supports = plan.supports;
    std::ranges::copy(plan.wide_supports, std::back_inserter(supports));
    const double steps =
        static_cast<double>(plan.kernels.size() * supports.size() * plan.samples_per_metre.size());
    Measured all;
    double step = 0;
    for (const std::string_view kernel : plan.kernels)
        for (const double support : supports)
            for (const int n : plan.samples_per_metre) {
                if (between_steps) between_steps(step++ / steps);
                const Situation<Dim> s(quantity, std::string(kernel), support, n, plan.places);
                Measured one = measure_situation(s, quantity, plan);
                std::ranges::move(one.candidates, std::back_inserter(all.candidates));
                std::ranges::copy(one.differences, std::back_inserter(all.differences));
            }
    return all;
}

template <int Dim> std::vector<std::string> names_of_methods(Quantity quantity) {
    const Situation<Dim> smallest(quantity, "poly6", 2.0, 4, 1);
    std::vector<std::string> names;
    for (auto* methods_of : {&sph_methods<Dim>, &mls_methods<Dim>})
        for (const PreparedMethod& method : methods_of(smallest, quantity))
            names.push_back(method.name);
    return names;
}
}  // namespace

std::vector<std::string> methods_compared(Quantity quantity, int dim) {
    return dim == 2 ? names_of_methods<2>(quantity) : names_of_methods<3>(quantity);
}

std::string_view name_of(Trend trend) {
    switch (trend) {
        case Trend::falls:
            return "falls";
        case Trend::saturated:
            return "saturated";
        case Trend::grows:
            return "grows";
        case Trend::unclear:
            return "unclear";
    }
    return "";
}

Frontier measure_frontier(Quantity quantity, int dim, Effort effort,
                          const std::function<void(double)>& between_steps) {
    const OneThread one_thread;
    const Plan plan = plan_of(dim, effort);
    Measured all = dim == 2 ? measure_situations<2>(quantity, plan, between_steps)
                            : measure_situations<3>(quantity, plan, between_steps);
    Frontier frontier{quantity, dim, std::move(all.candidates), 0.0, {}, {}};
    set_trends(frontier.candidates);
    frontier.noise = most_of(std::move(all.differences));
    for (const std::size_t k : pareto_front(frontier.candidates, &Candidate::per_field_s))
        frontier.candidates[k].on_front = true;
    frontier.precomputed = precomputed_ratios(frontier.candidates, frontier.noise);
    frontier.finding = finding_of(frontier.candidates, frontier.noise);
    return frontier;
}

}  // namespace benchmarks
