#pragma once

#include "benchmarks/neighbours/findings.h"
#include "benchmarks/neighbours/studies.h"

namespace benchmarks {

/// What a measurement says about a statement.
struct Verdict {
    std::string statement;
    std::string word;      // "holds", "does not hold", "cannot be told"
    std::string evidence;  // the numbers
    std::string source = "adams2009 Sec. 5.3";
};

/// On the statements of adams2009 Sec. 5.3 about kd-trees and hash grids that the study can judge: growth
/// and an even density if it is over the number of points, uneven density if it is over the contrast. The
/// hash grid is the faster of the two spacings. On the share of sorting if it is over the points that
/// move.
std::vector<Verdict> verdicts_on_section_5_3(const SearchStudyResult& study);

/// From which density contrast on the kd-tree is faster than the grids, one sentence.
std::string crossover_in_words(const std::vector<CaseResult>& cases);

}  // namespace benchmarks
