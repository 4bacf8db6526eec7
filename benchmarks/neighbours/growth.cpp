#include "benchmarks/neighbours/growth.h"

#include "benchmarks/framework/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace benchmarks {

namespace {
constexpr std::array places{"a core's own cache", "the shared cache", "main memory"};

/// Which of the places holds what a phase reads and writes.
std::size_t place_of(const CaseResult& c, const SearchResult& s, Phase phase) {
    const std::size_t bytes =
        c.points_bytes + s.held_bytes + (phase == Phase::query ? s.lists_bytes : 0);
    const CacheSizes caches = cache_sizes();
    return bytes <= caches.own ? 0 : bytes <= caches.shared ? 1 : 2;
}
}  // namespace

std::vector<GrowthIn> growth(const std::vector<CaseResult>& cases, const std::string& search,
                             Phase phase) {
    constexpr std::size_t least_levels = 3;
    const Cost cost = [phase](const Runs& runs) {
        return phase == Phase::build ? runs.build : runs.query;
    };
    std::vector<GrowthIn> all;
    for (std::size_t place = 0; place < places.size(); ++place) {
        std::vector<CaseResult> here;
        for (const CaseResult& c : cases) {
            const SearchResult* s = find_search(c, search);
            if (!s || place_of(c, *s, phase) != place) continue;
            CaseResult alone = c;
            alone.searches = {*s};
            here.push_back(std::move(alone));
        }
        if (here.size() < least_levels) continue;
        const auto [fewest, most] = std::ranges::minmax(here, {}, &CaseResult::count);
        const auto fitted = exponents(here, cost);
        if (!fitted.empty())
            all.push_back({places[place], fewest.count, most.count, fitted.front()});
    }
    return all;
}

Told follows(const std::vector<GrowthIn>& growth, Law law) {
    const auto allows = [](const Exponent& e, Law which) {
        return e.allows(which == Law::linear ? 1.0 : e.n_log_n);
    };
    const Law other = law == Law::linear ? Law::n_log_n : Law::linear;
    std::size_t allowed = 0, told_apart = 0;
    for (const GrowthIn& g : growth) {
        allowed += allows(g.exponent, law) ? 1 : 0;
        told_apart += allows(g.exponent, other) ? 0 : 1;
    }
    if (growth.empty()) return Told::unknown;
    if (allowed == 0) return Told::no;
    return allowed == growth.size() && told_apart > 0 ? Told::yes : Told::unknown;
}

std::string in_words(const std::string& search, const std::vector<GrowthIn>& growth) {
    if (growth.empty()) return search + ": fewer than three sizes in any one kind of memory";
    std::string text;
    for (const GrowthIn& g : growth)
        text +=
            fmt::format("{}n^{:.2f} [{:.2f}, {:.2f}] in {} ({} to {} points; n log n has {:.2f})",
                        text.empty() ? search + ": " : ", ", g.exponent.value, g.exponent.low,
                        g.exponent.high, g.place, g.fewest, g.most, g.exponent.n_log_n);
    return text;
}

}  // namespace benchmarks
