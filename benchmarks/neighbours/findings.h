#pragma once

#include "benchmarks/neighbours/comparison.h"

namespace benchmarks {

/// The seconds of each round that a search is judged by; empty if it was not measured.
using Cost = std::function<std::vector<double>(const Runs&)>;
std::vector<double> total_cost(const Runs& runs);

/// a's cost over b's.
Ratio ratio_of(const SearchResult& a, const SearchResult& b, const Cost& cost, double noise);

/// The search of that name, if it was compared and agrees.
const SearchResult* find_search(const CaseResult& result, const std::string& name);

/// Who is the fastest of those with a full answer: `best` holds the one with the least median cost, and after it those that cannot be
/// told from it; `next` is the fastest of the others, and `margin` its cost over that of the first.
struct Standing {
    std::vector<const SearchResult*> best;
    const SearchResult* next = nullptr;
    Ratio margin{1.0, 1.0, 1.0};
};
Standing standing_of(const CaseResult& result, const Cost& cost = total_cost);

/// The places that each search may have: 1 + the number of searches that are surely faster, to the number
/// of those that are not surely slower. No place for a search that was not timed, or whose
/// answer is not full.
struct Places {
    std::size_t first = 0, last = 0;
    bool operator==(const Places&) const = default;
};
std::vector<Places> places_of(const CaseResult& result, const Cost& cost = total_cost);

/// One sentence: "cell_grid, 3.1x (± 6 %) faster than hash_grid and 4.2x (± 5 %) than nanoflann
/// (a kd-tree), at 30 neighbours each"; or who cannot be told apart. Of those that are slower, it names the
/// one with the least median, and the kd-tree with the least.
std::string recommendation(const CaseResult& result);

/// How the time of a phase grows with the number n of points, over the cases of `all` that differ in n
/// alone: t ~ n^value, with a 95 % interval of Student from the misfit of the levels or the scatter of
/// the rounds, the wider one. Beside it, the exponent that n log n has over the same levels.
struct Exponent {
    std::string search;
    double value, low, high, n_log_n;

    bool allows(double exponent) const { return low <= exponent && exponent <= high; }
};
std::vector<Exponent> exponents(const std::vector<CaseResult>& all, const Cost& phase);

}  // namespace benchmarks
