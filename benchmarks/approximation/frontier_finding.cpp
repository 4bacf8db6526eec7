#include "benchmarks/approximation/frontier.h"
#include "benchmarks/framework/figures.h"
#include "benchmarks/framework/pareto.h"
#include "verification/framework/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace benchmarks {

namespace {
bool is_sph(const Candidate& c) { return c.method.starts_with("SPH") || c.method == "Brookshaw"; }

/// The smallest of … 1, 2, 5, 10, 20, … that is not below `error`.
double round_up(double error) {
    const double decade = std::pow(10.0, std::floor(std::log10(error)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= error) return digit * decade;
    return 10.0 * decade;
}

/// The cheapest per field of those that `may` be taken and reach `error`; none if there is none.
template <class May>
const Candidate* cheapest(const std::vector<Candidate>& candidates, double error, May may) {
    const Candidate* best = nullptr;
    for (const Candidate& c : candidates)
        if (!c.failed() && c.error <= error && may(c) &&
            (!best || c.per_field_s() < best->per_field_s()))
            best = &c;
    return best;
}

const Candidate* most_accurate(const std::vector<Candidate>& candidates, bool sph) {
    const Candidate* best = nullptr;
    for (const Candidate& c : candidates)
        if (!c.failed() && is_sph(c) == sph && (!best || c.error < best->error)) best = &c;
    return best;
}

std::string verdict_on(double ratio, double noise) {
    return ratio <= 1.0 + noise ? "holds" : "does not hold";
}

RatioRange range_of(const std::vector<double>& ratios) {
    const auto [low, high] = std::ranges::minmax(ratios);
    return {verification::median(ratios), low, high};
}

/// After how many evaluations `once` is paid back if each then takes `applied` instead of `anew` [s].
double paid_back_after(double once, double anew, double applied) {
    return anew > applied ? once / (anew - applied) : HUGE_VAL;
}

/// The upper of the two in the middle, which may be infinite, so that no mean of them exists.
double upper_median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// " up to h/dx = 6 and 27 samples per metre"
std::string extent_of_sph(const std::vector<Candidate>& candidates) {
    double widest = 0.0;
    int most = 0;
    for (const Candidate& c : candidates) {
        if (!is_sph(c)) continue;
        widest = std::max(widest, c.support_in_spacings);
        most = std::max(most, c.samples_per_metre);
    }
    return fmt::format(" up to h/dx = {:g} and {} samples per metre", widest, most);
}

/// Which kind reaches the error `target` for less time.
std::string cheaper_at(const std::vector<Candidate>& candidates, double target, double noise) {
    const Candidate* a = cheapest(candidates, target, is_sph);
    const Candidate* b =
        cheapest(candidates, target, [](const Candidate& c) { return !is_sph(c); });
    if (!b) return fmt::format("at {:.0e} only {} answers", target, a->method);
    const double ratio = a->per_field_s() / b->per_field_s();
    const auto [cheap, dear] = ratio >= 1.0 ? std::pair(b, a) : std::pair(a, b);
    const double factor = std::max(ratio, 1.0 / ratio);
    if (factor <= 1.0 + noise)
        return fmt::format("at {:.0e} this machine cannot tell whether {} or {} is cheaper", target,
                           cheap->method, dear->method);
    return fmt::format("at {:.0e} {} is {}x cheaper than {}", target, cheap->method,
                       factor_in_words(factor), dear->method);
}

/// The candidates that were timed in turns, on the same neighbours.
using Situations = std::map<std::tuple<std::string, double, int>, std::vector<const Candidate*>>;

Situations by_situation(const std::vector<Candidate>& candidates) {
    Situations all;
    for (const Candidate& c : candidates)
        all[{c.kernel, c.support_in_spacings, c.samples_per_metre}].push_back(&c);
    return all;
}
}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<Candidate>& candidates,
                                      const std::function<double(const Candidate&)>& cost) {
    return pareto_front_of(candidates, cost);
}

std::vector<PrecomputedRatio> precomputed_ratios(const std::vector<Candidate>& candidates,
                                                 double noise) {
    struct Ratios {
        bool sph;
        std::vector<double> over_precomputed, over_sum, precomputation, over_itself, over_sph;
    };
    std::map<std::string, Ratios> ratios;
    for (const auto& [key, group] : by_situation(candidates)) {
        const Candidate& sph = *group.front();  // Eq. 3, 9 or 11: the plain sum
        const auto compared = [](const Candidate* c) {
            return !is_sph(*c) && c->application && !c->failed();
        };
        if (!is_sph(sph) || !sph.application || std::ranges::none_of(group, compared)) continue;
        const double sum = sph.evaluation.median_s;
        for (const Candidate* c : group) {
            if (!c->application || c->failed()) continue;
            const double once = c->precomputation->median_s, applied = c->application->median_s;
            Ratios& r = ratios[c->method];
            r.sph = is_sph(*c);
            r.over_precomputed.push_back(applied / sph.application->median_s);
            r.over_sum.push_back(applied / sum);
            r.precomputation.push_back(once / sum);
            r.over_itself.push_back(paid_back_after(once, c->evaluation.median_s, applied));
            r.over_sph.push_back(paid_back_after(once, sum, applied));
        }
    }
    std::vector<PrecomputedRatio> all;
    for (const auto& [method, r] : ratios) {
        const RatioRange like_with_like = range_of(r.over_precomputed);
        all.push_back({method, like_with_like, range_of(r.over_sum),
                       verification::median(r.precomputation), upper_median(r.over_itself),
                       upper_median(r.over_sph),
                       r.sph ? "measure of the others" : verdict_on(like_with_like.median, noise)});
    }
    return all;
}

std::string finding_of(const std::vector<Candidate>& candidates, double noise) {
    const Candidate *sph = most_accurate(candidates, true),
                    *best = most_accurate(candidates, false);
    if (!sph || !best) return "no method of both kinds gave an answer: nothing to compare";
    const double least = round_up(sph->error);
    std::string finding = cheaper_at(candidates, 10.0 * least, noise) + "; " +
                          cheaper_at(candidates, least, noise) + ", the least of SPH" +
                          extent_of_sph(candidates);
    if (best->error < 0.5 * sph->error)
        finding += fmt::format("; {} reaches {:.0e}", best->method, best->error);
    return finding;
}

}  // namespace benchmarks
