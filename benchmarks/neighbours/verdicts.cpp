#include "benchmarks/neighbours/verdicts.h"

#include "verification/framework/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace benchmarks {

namespace {
using Cases = std::vector<CaseResult>;
constexpr const char* kd_tree = "kd_tree";

/// The faster of the two hash grids.
const SearchResult* hash_grid(const CaseResult& result) {
    const SearchResult* fastest = nullptr;
    for (const char* name : {"hash_grid", "hash_grid_r"})
        if (const SearchResult* s = find_search(result, name))
            if (!fastest || s->total().median_s < fastest->total().median_s) fastest = s;
    return fastest;
}

/// "3.1 [2.9, 3.4]".
std::string in_words(const Ratio& ratio) {
    return fmt::format("{:.2g} [{:.2g}, {:.2g}]", ratio.value, ratio.low, ratio.high);
}

std::string word_of(bool yes, bool no) {
    return yes ? "holds" : no ? "does not hold" : "cannot be told";
}

/// Whether the first takes longer than the second.
std::string word_of(const Ratio& ratio) { return word_of(ratio.low > 1.0, ratio.high < 1.0); }

const CaseResult& largest(const Cases& cases) {
    return *std::ranges::max_element(cases, {}, &CaseResult::count);
}

struct AtContrast {
    double contrast;
    Ratio ratio;
};

/// search / kd-tree over the contrast, at the largest number of points.
template <class Search> std::vector<AtContrast> over_kd_tree(const Cases& cases, Search search) {
    std::vector<AtContrast> all;
    for (const CaseResult& c : cases) {
        const SearchResult *other = search(c), *tree = find_search(c, kd_tree);
        if (c.count != largest(cases).count || !other || !tree) continue;
        all.push_back({c.contrast.value_or(1.0), ratio_of(*other, *tree, total_cost, c.noise)});
    }
    std::ranges::sort(all, {}, &AtContrast::contrast);
    return all;
}

std::string in_words(const std::vector<AtContrast>& all) {
    std::string text;
    for (const AtContrast& at : all)
        text += fmt::format("{}{} at 1:{:g}", text.empty() ? "" : ", ", in_words(at.ratio),
                            at.contrast);
    return text;
}

/// The contrast from which on all ratios are surely above 1.
std::string crossover(const std::vector<AtContrast>& all) {
    std::size_t from = all.size();
    while (from > 0 && all[from - 1].ratio.low > 1.0) --from;
    if (from < all.size())
        return fmt::format("the kd-tree is surely faster from 1:{:g} on", all[from].contrast);
    if (all.back().ratio.high < 1.0)
        return fmt::format("the kd-tree is slower even at 1:{:g}", all.back().contrast);
    return fmt::format("whether the kd-tree is faster at 1:{:g} cannot be told",
                       all.back().contrast);
}

std::string radius_in_words(const Cases& cases) {
    return cases.front().own_radii ? "each point with its own radius" : "one radius for all";
}

const SearchResult* cell_grid(const CaseResult& c) { return find_search(c, "cell_grid"); }

void judge_adaptivity(const Cases& cases, std::vector<Verdict>& verdicts) {
    const std::string radius = radius_in_words(cases);
    const auto hash = over_kd_tree(cases, hash_grid);
    if (hash.empty()) return;
    std::string evidence = fmt::format(
        "time of the hash grid over that of the kd-tree, {} points graded in density, {}: {}; {}.",
        largest(cases).count, radius, in_words(hash), crossover(hash));
    const auto cells = over_kd_tree(cases, cell_grid);
    if (!cells.empty())
        evidence += fmt::format(" The grid of sorted, occupied cells: {}; {}.", in_words(cells),
                                crossover(cells));
    verdicts.push_back({fmt::format("With strongly varying density, kd-trees have advantages over "
                                    "hash grids ({})",
                                    radius),
                        word_of(hash.back().ratio), evidence});
}

const Exponent* find(const std::vector<Exponent>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &Exponent::search);
    return found == all.end() ? nullptr : &*found;
}

std::string in_words(const Exponent& e) {
    return fmt::format("{} n^{:.2f} [{:.2f}, {:.2f}]", e.search, e.value, e.low, e.high);
}

void judge_growth(const Cases& cases, std::vector<Verdict>& verdicts) {
    const auto build = exponents(cases, [](const Runs& runs) { return runs.build; });
    const auto query = exponents(cases, [](const Runs& runs) { return runs.query; });
    const SearchResult* fastest = hash_grid(largest(cases));
    const Exponent* tree = find(build, kd_tree);
    const Exponent* grid = fastest ? find(build, fastest->name) : nullptr;
    const Exponent* asked = fastest ? find(query, fastest->name) : nullptr;
    if (!tree || !grid || !asked) return;
    const std::string range = fmt::format(
        "{} to {} points", std::ranges::min_element(cases, {}, &CaseResult::count)->count,
        largest(cases).count);
    const bool both = tree->allows(tree->n_log_n) && grid->allows(1.0);
    const bool too_wide = tree->allows(1.0) || grid->allows(grid->n_log_n);
    verdicts.push_back(
        {"A kd-tree is built in O(n log n), a hash grid in O(n)", word_of(both && !too_wide, !both),
         fmt::format(
             "build times from {}: {}, {}; n log n is n^{:.2f} there. Times also grow where "
             "the points leave a cache.",
             range, in_words(*tree), in_words(*grid), tree->n_log_n)});
    const CaseResult &most = largest(cases),
                     &few = *std::ranges::min_element(cases, {}, &CaseResult::count);
    const auto per_point = [&](const CaseResult& c) {
        const SearchResult* s = find_search(c, fastest->name);
        return s ? 1e9 * s->query().median_s / static_cast<double>(c.count) : NAN;
    };
    verdicts.push_back(
        {"At a constant radius and an even density, a hash grid retrieves in O(1)",
         word_of(asked->allows(1.0) && !asked->allows(asked->n_log_n), !asked->allows(1.0)),
         fmt::format("query of all points from {}: {}; n^1 is O(1) for each, n^{:.2f} O(log n). "
                     "{:.0f} ns per point at {}, {:.0f} at {}.",
                     range, in_words(*asked), asked->n_log_n, per_point(few), few.count,
                     per_point(most), most.count)});
}

void judge_even_density(const CaseResult& result, std::vector<Verdict>& verdicts) {
    const SearchResult *grid = hash_grid(result), *tree = find_search(result, kd_tree);
    if (!grid || !tree) return;
    const Ratio total = ratio_of(*tree, *grid, total_cost, result.noise);
    verdicts.push_back(
        {"Hash grids are the most efficient for one known radius (here: than a kd-tree, at an even "
         "density)",
         word_of(total),
         fmt::format("time of the kd-tree over that of the hash grid, {} points: {}.", result.count,
                     in_words(total))});
    const auto share = [](const Runs& runs) {
        std::vector<double> shares;
        for (std::size_t k = 0; k < runs.rounds(); ++k)
            shares.push_back(runs.build[k] / (runs.build[k] + runs.query[k]));
        return shares;
    };
    const Ratio shares = ratio_of(*tree, *grid, share, result.noise);
    verdicts.push_back(
        {"When points move, it is the kd-tree whose construction becomes limiting", word_of(shares),
         fmt::format("built and asked once per step, {} points: building takes {:.2g} % of the "
                     "kd-tree's time and {:.2g} % of the hash grid's, {} times the share.",
                     result.count, 100.0 * verification::median(share(tree->runs)),
                     100.0 * verification::median(share(grid->runs)), in_words(shares))});
}
}  // namespace

std::string crossover_in_words(const std::vector<CaseResult>& cases) {
    std::string text = radius_in_words(cases);
    text.front() = static_cast<char>(std::toupper(text.front()));
    const auto add = [&](const char* name, const std::vector<AtContrast>& ratios) {
        if (!ratios.empty())
            text += fmt::format("{} beside the {}, {}", text.back() == ':' ? "" : ";", name,
                                crossover(ratios));
    };
    text += ':';
    add("hash grid", over_kd_tree(cases, hash_grid));
    add("cell grid", over_kd_tree(cases, cell_grid));
    if (text.back() == ':') text += " nothing to compare with a kd-tree";
    return text;
}

std::vector<Verdict> verdicts_on_section_5_3(const SearchStudyResult& study) {
    std::vector<Verdict> verdicts;
    if (study.name == "contrast" || study.name == "own_radii")
        judge_adaptivity(study.cases, verdicts);
    if (study.name == "size") {
        judge_growth(study.cases, verdicts);
        judge_even_density(largest(study.cases), verdicts);
    }
    return verdicts;
}

}  // namespace benchmarks
