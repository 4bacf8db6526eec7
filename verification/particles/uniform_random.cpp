#include "solver/particles/uniform_random.h"

#include "verification/framework/registry.h"

namespace uniform_random_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr int cells_along = 10;

/// χ² of the counts in 10³ equal cells against the same number in each, over its mean, 999.
double chi_squared_ratio(const Points<3>& points) {
    constexpr int cells = cells_along * cells_along * cells_along;
    std::vector<double> count(cells);
    for (const Vec<3>& x : points) {
        const auto k = (x * cells_along).cast<int>().eval();
        ++count[static_cast<std::size_t>((k[2] * cells_along + k[1]) * cells_along + k[0])];
    }
    const double expected = static_cast<double>(points.size()) / cells;
    double sum = 0;
    for (const double c : count) sum += (c - expected) * (c - expected) / expected;
    return sum / (cells - 1);
}
/// One random number for all three coordinates of a point, a frequent slip.
Points<3> on_the_diagonal(Index n) {
    Random random(1);
    Points<3> points(n);
    for (Vec<3>& x : points) x.setConstant(random.uniform());
    return points;
}

const Register claims_of_uniform_random{
    Claim{.id = "uniform_random.fills_every_part_alike",
          .source = {Paper::plumbline, "docstring of uniform_random"},
          .says = "counts in 1000 cells vary as those of independent points: χ² is 999 on average",
          .bound = between(1 - 0.224, 1 + 0.224, "5 standard deviations √(2/999) of χ²₉₉₉/999"),
          .measure = [] { return chi_squared_ratio(uniform_random(unit_box<3>(), 100000, 1)); },
          .sabotaged = [] { return chi_squared_ratio(on_the_diagonal(100000)); }},
};
}  // namespace
}  // namespace uniform_random_claims
