#include "benchmarks/neighbours/findings.h"

#include "verification/framework/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace benchmarks {

namespace {
double median_of(const SearchResult& search, const Cost& cost) {
    return verification::median(cost(search.runs));
}

/// Those that agree and were timed, the fastest first.
std::vector<const SearchResult*> by_cost(const CaseResult& result, const Cost& cost) {
    std::vector<const SearchResult*> timed;
    for (const SearchResult& s : result.searches)
        if (s.agrees() && s.is_full_answer && !cost(s.runs).empty()) timed.push_back(&s);
    std::ranges::stable_sort(timed, {}, [&](const auto* s) { return median_of(*s, cost); });
    return timed;
}

/// "3.1x (± 6 %)", or with both ends where they are far.
std::string in_words(const Ratio& ratio) {
    if (!std::isfinite(ratio.high))
        return fmt::format("{:.2g}x (uncertain: fewer than {} rounds)", ratio.value, least_rounds);
    if (ratio.relative() > 0.5)
        return fmt::format("{:.2g}x (between {:.2g}x and {:.2g}x)", ratio.value, ratio.low,
                           ratio.high);
    return fmt::format("{:.2g}x (± {:.0f} %)", ratio.value,
                       std::max(1.0, 100.0 * ratio.relative()));
}

std::string joined(const std::vector<const SearchResult*>& searches) {
    std::string text;
    for (std::size_t k = 0; k < searches.size(); ++k)
        text += (k == 0 ? "" : k + 1 == searches.size() ? " or " : ", ") + searches[k]->name;
    return text;
}

bool is_kd_tree(const SearchResult& search) {
    return search.name.find("kd_tree") != std::string::npos ||
           search.name.find("leaf_tree") != std::string::npos ||
           search.name.find("nanoflann") != std::string::npos;
}
}  // namespace

std::vector<double> total_cost(const Runs& runs) { return runs.total(); }

Ratio ratio_of(const SearchResult& a, const SearchResult& b, const Cost& cost, double noise) {
    return ratio_of(cost(a.runs), cost(b.runs), noise);
}

const SearchResult* find_search(const CaseResult& result, const std::string& name) {
    for (const SearchResult& s : result.searches)
        if (s.name == name && s.agrees()) return &s;
    return nullptr;
}

Standing standing_of(const CaseResult& result, const Cost& cost) {
    Standing standing;
    for (const SearchResult* s : by_cost(result, cost)) {
        if (standing.best.empty()) {
            standing.best.push_back(s);
            continue;
        }
        const Ratio ratio = ratio_of(*s, *standing.best.front(), cost, result.noise);
        if (ratio.low <= 1.0) {
            standing.best.push_back(s);
        } else if (!standing.next) {
            standing.next = s;
            standing.margin = ratio;
        }
    }
    return standing;
}

std::vector<Places> places_of(const CaseResult& result, const Cost& cost) {
    std::vector<Places> places(result.searches.size());
    const auto timed = by_cost(result, cost);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const SearchResult& search = result.searches[k];
        if (std::ranges::find(timed, &search) == timed.end()) continue;
        places[k] = {1, timed.size()};
        for (const SearchResult* other : timed) {
            if (other == &search) continue;
            const Ratio ratio = ratio_of(search, *other, cost, result.noise);
            if (ratio.low > 1.0) ++places[k].first;
            if (ratio.high < 1.0) --places[k].last;
        }
    }
    return places;
}

std::string recommendation(const CaseResult& result) {
    const Standing standing = standing_of(result);
    if (standing.best.empty()) return "no search agrees with brute force";
    std::string text = joined(standing.best);
    if (standing.best.size() > 1) text += " (which is faster cannot be told)";
    const SearchResult& fastest = *standing.best.front();
    if (standing.next)
        text += fmt::format(", {} faster than {}", in_words(standing.margin), standing.next->name);
    else if (standing.best.size() == 1)
        text += ", the only one compared";
    if (standing.next && !is_kd_tree(fastest) && !is_kd_tree(*standing.next))
        for (const SearchResult* s : by_cost(result, total_cost)) {
            const Ratio ratio = ratio_of(*s, fastest, total_cost, result.noise);
            if (!is_kd_tree(*s) || ratio.low <= 1.0) continue;
            text += fmt::format(" and {} than {}", in_words(ratio), s->name);
            if (s->name.find("kd_tree") == std::string::npos) text += " (a kd-tree)";
            break;
        }
    return text + fmt::format(", at {:.0f} neighbours each", result.mean_neighbours);
}

std::vector<Exponent> exponents(const std::vector<CaseResult>& all, const Cost& phase) {
    std::vector<Exponent> found;
    if (all.empty()) return found;
    std::vector<const CaseResult*> levels;
    for (const CaseResult& c : all) levels.push_back(&c);
    std::ranges::sort(levels, {}, &CaseResult::count);
    for (const SearchResult& search : all.front().searches) {
        std::vector<double> spacing;
        std::vector<std::vector<double>> times;
        double first = 0.0, last = 0.0;
        for (const CaseResult* level : levels) {
            const SearchResult* s = find_search(*level, search.name);
            const auto n = static_cast<double>(level->count);
            if (!s || phase(s->runs).empty() || (!spacing.empty() && n <= last)) continue;
            if (spacing.empty()) first = n;
            last = n;
            spacing.push_back(1.0 / n);
            times.push_back(phase(s->runs));
        }
        if (spacing.size() < 2 || first < 2.0) continue;
        const auto law = verification::fit_power_law(spacing, times);
        const double n_log_n =
            1.0 + std::log(std::log(last) / std::log(first)) / std::log(last / first);
        found.push_back(
            {search.name, -law.order, -law.confidence.high, -law.confidence.low, n_log_n});
    }
    return found;
}

}  // namespace benchmarks
