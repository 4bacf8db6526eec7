#include "benchmarks/neighbours/verdicts.h"

#include "benchmarks/neighbours/growth.h"
#include "verification/framework/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace benchmarks {

namespace {
using Cases = std::vector<CaseResult>;
constexpr const char* kd_tree = "kd_tree";

/// That with the least median of the total.
const SearchResult* fastest_of(const CaseResult& result, const std::vector<const char*>& names) {
    const SearchResult* fastest = nullptr;
    for (const char* name : names)
        if (const SearchResult* s = find_search(result, name))
            if (!fastest || s->total().median_s < fastest->total().median_s) fastest = s;
    return fastest;
}
const SearchResult* hash_grid(const CaseResult& result) {
    return fastest_of(result, {"hash_grid", "hash_grid_r"});
}

/// "3.1 [2.9, 3.4]".
std::string with_interval(const Ratio& ratio) {
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

std::string with_interval(const std::vector<AtContrast>& all) {
    std::string text;
    for (const AtContrast& at : all)
        text += fmt::format("{}{} at 1:{:g}", text.empty() ? "" : ", ", with_interval(at.ratio),
                            at.contrast);
    return text;
}

/// The contrast from which on all ratios are surely above 1, and that up to which they are surely below.
std::string crossover(const std::vector<AtContrast>& all) {
    std::size_t from = all.size(), up_to = 0;
    while (from > 0 && all[from - 1].ratio.low > 1.0) --from;
    while (up_to < all.size() && all[up_to].ratio.high < 1.0) ++up_to;
    if (up_to == all.size())
        return fmt::format("the kd-tree is slower even at 1:{:g}", all.back().contrast);
    const std::string below =
        up_to == 0 ? "" : fmt::format("slower up to 1:{:g}, ", all[up_to - 1].contrast);
    if (from < all.size())
        return fmt::format("the kd-tree is surely {}faster from 1:{:g} on", below,
                           all[from].contrast);
    return fmt::format("whether the kd-tree is faster at 1:{:g} cannot be told",
                       all.back().contrast);
}

std::string radius_in_words(const Cases& cases) {
    return cases.front().own_radii ? "each point with its own radius" : "one radius for all";
}

const SearchResult* cell_grid(const CaseResult& c) { return find_search(c, "cell_grid"); }

/// The fastest grid and the fastest tree that give lists of one form.
std::string fastest_in_words(const Cases& cases) {
    std::string text;
    for (const CaseResult& c : cases) {
        const SearchResult* grid = fastest_of(c, {"cell_grid_packed", "level_grid_packed"});
        const SearchResult* tree = fastest_of(c, {"leaf_tree_packed", "nanoflann_packed"});
        if (c.count != largest(cases).count || !grid || !tree) continue;
        text += fmt::format("{}{} {} at 1:{:g}", text.empty() ? "" : ", ", grid->name,
                            with_interval(ratio_of(*grid, *tree, total_cost, c.noise)),
                            c.contrast.value_or(1.0));
    }
    return text.empty()
               ? text
               : fmt::format(" The fastest grid over the fastest tree, with lists as found: {}.",
                             text);
}

void judge_adaptivity(const Cases& cases, std::vector<Verdict>& verdicts) {
    const std::string radius = radius_in_words(cases);
    const auto hash = over_kd_tree(cases, hash_grid);
    if (hash.empty()) return;
    std::string evidence = fmt::format(
        "time of the hash grid over that of the kd-tree, {} points graded in density, {}: {}; {}.",
        largest(cases).count, radius, with_interval(hash), crossover(hash));
    const auto cells = over_kd_tree(cases, cell_grid);
    if (!cells.empty())
        evidence += fmt::format(" The grid of sorted, occupied cells: {}; {}.",
                                with_interval(cells), crossover(cells));
    evidence += fastest_in_words(cases);
    verdicts.push_back({fmt::format("With strongly varying density, kd-trees have advantages over "
                                    "hash grids ({})",
                                    radius),
                        word_of(hash.back().ratio), evidence});
}

std::string word_of(Told told) { return word_of(told == Told::yes, told == Told::no); }

Told both(Told a, Told b) {
    if (a == Told::no || b == Told::no) return Told::no;
    return a == Told::yes && b == Told::yes ? Told::yes : Told::unknown;
}

void judge_growth(const Cases& cases, std::vector<Verdict>& verdicts) {
    const SearchResult* fastest = hash_grid(largest(cases));
    if (!fastest || !find_search(largest(cases), kd_tree)) return;
    const auto tree = growth(cases, kd_tree, Phase::build);
    const auto grid = growth(cases, fastest->name, Phase::build);
    verdicts.push_back({"A kd-tree is built in O(n log n), a hash grid in O(n)",
                        word_of(both(follows(tree, Law::n_log_n), follows(grid, Law::linear))),
                        fmt::format("build times, apart for each kind of memory that holds what is "
                                    "built: {}; {}.",
                                    in_words(kd_tree, tree), in_words(fastest->name, grid))});
    const auto asked = growth(cases, fastest->name, Phase::query);
    verdicts.push_back({"At a constant radius and an even density, a hash grid retrieves in O(1)",
                        word_of(follows(asked, Law::linear)),
                        fmt::format("queries of all points, of which n^1 is O(1) for each: {}.",
                                    in_words(fastest->name, asked))});
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
                     with_interval(total))});
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
                     100.0 * verification::median(share(grid->runs)), with_interval(shares))});
}
/// Of moving points: how much a search spends on sorting, and so what a partial re-sort can save at most.
void judge_sorting(const Cases& cases, std::vector<Verdict>& verdicts) {
    std::string evidence;
    bool all_more = true, all_less = true;
    for (const CaseResult& c : cases) {
        const SearchResult* s = find_search(c, "cell_grid_packed");
        if (!s || s->runs.update.empty()) continue;
        const Ratio share = ratio_of(s->runs.update, s->runs.step(), c.noise);
        all_more &= share.low > 0.5;
        all_less &= share.high < 0.5;
        evidence += fmt::format("{}{:.0f} [{:.0f}, {:.0f}] % of a step with {:g} % moved",
                                evidence.empty() ? "" : ", ", 100.0 * share.value,
                                100.0 * share.low, 100.0 * share.high, 100.0 * c.moved);
    }
    if (evidence.empty()) return;
    verdicts.push_back(
        {"Most of a step of moving points is sorting them into cells anew (so that sorting only "
         "those "
         "that changed cell would pay)",
         word_of(all_more, all_less),
         fmt::format(
             "cell_grid_packed sorts all points in {} ({} points); a partial sort can save no "
             "more than that, whatever it costs itself.",
             evidence, largest(cases).count)});
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
    if (study.name == "moved") judge_sorting(study.cases, verdicts);
    if (study.name == "size") {
        judge_growth(study.cases, verdicts);
        judge_even_density(largest(study.cases), verdicts);
    }
    return verdicts;
}

}  // namespace benchmarks
