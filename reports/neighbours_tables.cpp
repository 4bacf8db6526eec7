#include "reports/neighbours_tables.h"

#include "benchmarks/neighbours/verdicts.h"
#include "reports/neighbours_report.h"

#include <fmt/format.h>

#include <cmath>

namespace reports {

using namespace benchmarks;

namespace {
std::string place_in_words(const Places& places) {
    if (places == Places{}) return "-";
    return places.first == places.last ? fmt::format("{}", places.first)
                                       : fmt::format("{}-{}", places.first, places.last);
}

std::string over_fastest(const SearchResult& s, const SearchResult& fastest, double noise) {
    if (&s == &fastest) return "1";
    const Ratio r = ratio_of(s, fastest, total_cost, noise);
    if (!std::isfinite(r.high)) return fmt::format("{:.2f}", r.value);
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", r.value, r.low, r.high);
}

std::string row_of(const CaseResult& c, const SearchResult& s, const Places& places,
                   const SearchResult& fastest) {
    const auto n = static_cast<double>(c.count);
    const auto ns = [&](double seconds) { return 1e9 * seconds / n; };
    const auto with_spread = [&](const Timing& t) {
        return fmt::format("{:.1f} ± {:.1f}", ns(t.median_s), ns(t.mad_s));
    };
    std::string row = fmt::format("{:<18} {:>5} {:>15} {:>15}", s.name, place_in_words(places),
                                  with_spread(s.build()), with_spread(s.query()));
    if (c.moved > 0.0) row += fmt::format(" {:>15}", with_spread(s.update()));
    row += fmt::format(" {:>9.1f} {:>9.1f} {:>8.1f} {:>8}  {}\n", ns(s.total().median_s),
                       ns(s.cold_build_s + s.cold_query_s), static_cast<double>(s.held_bytes) / n,
                       s.peak_bytes && c.count >= 100000
                           ? fmt::format("{:.1f}", static_cast<double>(*s.peak_bytes) / n)
                           : "",
                       over_fastest(s, fastest, c.noise));
    return row;
}

}  // namespace

std::string table_of(const CaseResult& c) {
    std::string text = fmt::format(
        "{}: {:.1f} neighbours each, {:.1f} times as many at the 99th percentile as at the first\n"
        "agreement: {} with brute force on {} of {} rows, the others with it on all; A/A noise "
        "{:.1f} %\n",
        in_words(c), c.mean_neighbours, c.unevenness, c.searches.front().name, c.brute_force_rows,
        c.count, 100.0 * c.noise);
    text += fmt::format("{:<18} {:>5} {:>15} {:>15}", "ns per point", "place", "build", "query");
    if (c.moved > 0.0) text += fmt::format(" {:>15}", "update");
    text += fmt::format(" {:>9} {:>9} {:>8} {:>8}  {}\n", "total", "cold", "B/point", "peak B",
                        "of the fastest");
    const Standing standing = standing_of(c);
    const auto places = places_of(c);
    for (std::size_t k = 0; k < c.searches.size(); ++k) {
        const SearchResult& s = c.searches[k];
        text += !s.left_out.empty() ? fmt::format("{:<18} left out: {}\n", s.name, s.left_out)
                : s.agrees()
                    ? row_of(c, s, places[k], standing.best.empty() ? s : *standing.best.front())
                    : fmt::format("{:<18} DISAGREES: {} wrong pairs; not timed\n", s.name,
                                  s.wrong_pairs);
    }
    if (c.one_at_a_time)
        text += "too large to be in memory side by side: each was made anew for each of its runs\n";
    constexpr double busy = 0.2;  // an idle machine shows a few per cent
    if (c.noise > busy) text += "the machine is busy: measure again when it is not\n";
    text += "lists: one after the other, indices ascending in each, unless another form is named\n";
    for (const SearchResult& s : c.searches)
        if (s.form != SearchResult{}.form)
            text += fmt::format("{}: {}{}\n", s.name, s.form,
                                s.is_full_answer ? "" : "; another answer, so without a place");
    return text + fmt::format("use {}\n\n", recommendation(c));
}

std::string tables_of(const SearchStudyResult& study) {
    std::string text = study.question + "\n\n";
    for (const CaseResult& c : study.cases) text += table_of(c);
    if (study.name == "size") {
        const auto build = exponents(study.cases, [](const Runs& runs) { return runs.build; });
        const auto query = exponents(study.cases, [](const Runs& runs) { return runs.query; });
        if (!build.empty())
            text += fmt::format(
                "time ~ points^exponent; n log n has {:.2f} here\n{:<18} {:>22} {:>22}\n",
                build.front().n_log_n, "", "build", "query");
        const auto in_words = [](const Exponent& e) {
            return fmt::format("{:.2f} [{:.2f}, {:.2f}]", e.value, e.low, e.high);
        };
        for (std::size_t k = 0; k < std::min(build.size(), query.size()); ++k)
            text += fmt::format("{:<18} {:>22} {:>22}\n", build[k].search, in_words(build[k]),
                                in_words(query[k]));
        if (!build.empty()) text += '\n';
    }
    for (const benchmarks::Verdict& v : verdicts_on_section_5_3(study))
        text += fmt::format("{}: {}: {}.\n  {}\n", v.source, v.statement, v.word, v.evidence);
    return text;
}

}  // namespace reports
