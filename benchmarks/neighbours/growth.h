#pragma once

#include "benchmarks/neighbours/findings.h"

namespace benchmarks {

/// How a search's time grows over those cases in which what it works on is in one kind of memory: a core's own cache, the one that cores share, or beyond. Where it leaves a cache the time
/// grows, whatever the law.
struct GrowthIn {
    std::string place;
    std::size_t fewest, most;  // points
    Exponent exponent;
};

enum class Phase { build, query };

/// One for each kind of memory that holds at least three of the cases.
std::vector<GrowthIn> growth(const std::vector<CaseResult>& cases, const std::string& search,
                             Phase phase);

enum class Law { linear, n_log_n };
enum class Told { yes, no, unknown };

/// Yes if the law is allowed in each kind of memory, and the other one is not in at least one; no if it is
/// allowed in none.
Told follows(const std::vector<GrowthIn>& growth, Law law);

/// "hash_grid: n^1.02 [0.97, 1.07] in the shared cache (10000 to 100000 points; n log n has 1.09), …".
std::string in_words(const std::string& search, const std::vector<GrowthIn>& growth);

}  // namespace benchmarks
