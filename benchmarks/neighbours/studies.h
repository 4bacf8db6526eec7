#pragma once

#include "benchmarks/neighbours/comparison.h"

namespace benchmarks {

/// A case to measure.
struct SearchSituation {
    CloudRequest cloud = {};
    int dim = 3;
    std::string order = "shuffled";
    std::optional<double> spacings = {}, moved = {};  // see ComparisonOptions
    std::optional<double> radius = {};                // instead of the cloud's
    bool own_radii = false;
    int threads = 0;

    /// "graded 3D, 10000 points".
    std::string in_words() const;
};

/// Makes the cloud and compares; the fields of `how` that a situation has are set by it.
CaseResult measure(const SearchSituation& situation, ComparisonOptions how);

enum class Level { quick, usual };

/// Situations that differ in one or two things, to answer a question.
struct SearchStudy {
    std::string name, question;
    std::vector<SearchSituation> situations;
};

/// size, cloud, order, radius, contrast (one radius for all), own_radii (over the contrast), moved,
/// threads. The quick level takes some 20 s on two cores, the usual one some minutes.
std::vector<SearchStudy> search_studies(Level level);

/// How often and how long each case is measured at that level.
ComparisonOptions effort(Level level);

/// The measured cases of a study.
struct SearchStudyResult {
    std::string name, question;
    std::vector<CaseResult> cases;
};

}  // namespace benchmarks
