#include "solver/scene/guarded_run.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plumbline {

namespace {
constexpr std::size_t steps_between_copies = 16;

std::string as_text(const Snapshot& s, std::size_t i) {
    std::ostringstream text;
    for (int d = 0; d < s.dim; ++d) text << (d == 0 ? "(" : ", ") << s.coordinate(i, d);
    return text.str() + ")";
}
bool all_finite(std::span<const double> numbers, std::size_t& first) {
    const auto bad = std::ranges::find_if(numbers, [](double x) { return !std::isfinite(x); });
    first = static_cast<std::size_t>(bad - numbers.begin());
    return bad == numbers.end();
}
}  // namespace

Box<3> domain_of(const SceneFile& scene, const Snapshot& start) {
    if (scene.domain) return {(*scene.domain)[0], (*scene.domain)[1]};
    Box<3> box{Vec<3>::Constant(HUGE_VAL), Vec<3>::Constant(-HUGE_VAL)};
    for (const auto& numbers : {start.x, start.ghosts})
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto d = static_cast<int>(k % static_cast<std::size_t>(start.dim));
            box.low[d] = std::min(box.low[d], numbers[k]);
            box.high[d] = std::max(box.high[d], numbers[k]);
        }
    double margin = 0.0;
    for (int d = 0; d < start.dim; ++d) margin = std::max(margin, box.high[d] - box.low[d]);
    margin = std::max(margin, scene.support);
    for (int d = 0; d < start.dim; ++d) box.low[d] -= margin, box.high[d] += margin;
    return box;
}

NextStep next_step(const SceneFile& scene, const TimeStepLimits& limits, double time,
                   double event) {
    double wanted = scene.step.value_or(limits.smallest());
    std::string_view why = scene.step ? "fixed" : limits.binding();
    if (scene.largest_step && *scene.largest_step < wanted)
        wanted = *scene.largest_step, why = "largest";
    if (!(wanted > 1e-12 * scene.end)) {
        std::ostringstream text;
        text << "the time step fell to " << wanted << " s by the limit \"" << why
             << "\" at t = " << time << " s: the simulation has blown up";
        throw SimulationFailed(text.str());
    }
    const double rest = event - time;
    const bool halved = !scene.step && rest < 2.0 * wanted && rest > wanted * (1.0 + 1e-9);
    if (halved) return {0.5 * rest, "output", time + 0.5 * rest};
    if (rest > wanted * (1.0 + 1e-9)) return {wanted, why, time + wanted};
    if (rest >= wanted * (1.0 - 1e-9)) return {wanted, why, event};
    return {rest, "output", event};
}

void GuardedRun::restart_at(double time, std::size_t steps) {
    time_ = time, steps_ = steps;
    kept_.clear();
    since_kept_.clear();
}

void GuardedRun::step(const NextStep& next) {
    if (kept_.empty() || since_kept_.size() == steps_between_copies) {
        kept_.clear();
        simulation_.save(kept_);
        since_kept_.clear();
    }
    std::string thrown;
    try {
        simulation_.step(next.dt);
    } catch (const InvalidInput& e) {
        thrown = e.what();
    }
    if (!thrown.empty() || trouble()) explain(next, thrown);
    since_kept_.push_back(next.dt);
    time_ = next.end, ++steps_;
}

std::optional<GuardedRun::Trouble> GuardedRun::trouble() const {
    const Snapshot s = simulation_.snapshot();
    const auto dim = static_cast<std::size_t>(s.dim);
    std::size_t first = 0;
    for (const auto& numbers : {s.x, s.v})
        if (!all_finite(numbers, first)) return Trouble{Trouble::not_finite, first / dim};
    for (const auto& numbers : {s.rho, s.p})
        if (!all_finite(numbers, first)) return Trouble{Trouble::not_finite, first};
    for (std::size_t k = 0; k < s.x.size(); ++k) {
        const auto d = static_cast<int>(k % dim);
        if (s.x[k] < domain_.low[d] || s.x[k] > domain_.high[d])
            return Trouble{Trouble::escaped, k / dim};
    }
    for (std::size_t k = 0; k < s.bodies.size(); ++k)
        for (int d = 0; d < s.dim; ++d)
            if (const double x = s.bodies[k].centre[d];
                !(x >= domain_.low[d] && x <= domain_.high[d]))
                return Trouble{Trouble::body_escaped, k};
    return std::nullopt;
}

void GuardedRun::explain(const NextStep& next, const std::string& thrown) {
    const Trouble found = trouble().value_or(Trouble{Trouble::not_finite, 0});
    simulation_.load(kept_);
    for (const double dt : since_kept_) simulation_.step(dt);
    std::string good;
    simulation_.save(good);
    Diagnosis why;
    try {
        why = simulation_.step_watched(next.dt,
                                       found.kind == Trouble::body_escaped ? 0 : found.number);
    } catch (const InvalidInput&) {  // nothing in it was not finite: `thrown` says what it was
    }
    std::ostringstream text;
    text.precision(6);
    const auto at = [&] { text << " at t = " << next.end << " s (step " << steps_ + 1 << ")"; };
    if (!why.fault_term.empty()) {
        text << "particle " << why.fault_particle << ": \"" << why.fault_quantity
             << "\" is not finite";
        at();
        text << ", after the term \"" << why.fault_term << "\"";
    } else if (found.kind == Trouble::body_escaped) {
        text << "body " << found.number + 1 << " left the domain";
        at();
    } else if (found.kind == Trouble::escaped) {
        text << "particle " << found.number << " left the domain";
        at();
        text << ", for " << as_text(simulation_.snapshot(), found.number)
             << " m; the term that accelerated it most, by " << why.strongest << " m/s2, is \""
             << why.strongest_term << "\"";
    } else {
        text << "particle " << found.number << ": the step cannot be made";
        at();
        text << (thrown.empty() ? "" : ": ") << thrown;
    }
    simulation_.load(good);
    throw SimulationFailed(text.str());
}

}  // namespace plumbline
