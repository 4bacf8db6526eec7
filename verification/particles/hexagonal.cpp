#include "solver/particles/hexagonal.h"

#include "verification/framework/registry.h"
#include "verification/particles/shells.h"

namespace hexagonal_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double D = 0.05;
/// 20 × 12 periods.
const Box<2> box{{0.0, 0.0}, {20 * D, 12 * std::sqrt(3.0) * D}};

/// Every second row moved by half a spacing, as it should be, but the rows D apart.
Points<2> rows_at_one_spacing() {
    return cell_centres<2>(box, {0.5 * D, D}, [](const auto& k) { return (k[0] + k[1]) % 2 == 0; });
}

double misplaced(const Points<2>& points) {
    return misplaced_neighbours(
        points, box, D, {{1, 6}, {std::sqrt(3.0), 6}, {2, 6}, {std::sqrt(7.0), 12}, {3, 6}});
}
double area_error(const Points<2>& points) {
    return volume_error(points, box, 0.5 * std::sqrt(3.0) * D * D);
}

const Register claims_of_hexagonal{
    Claim{.id = "hexagonal.shells",
          .source = {Paper::wicke2006, "Eq. 1"},
          .says = "in the plane 6, 6, 6, 12, 6 neighbours at D √(1, 3, 4, 7, 9)",
          .bound = at_most(0, "a count of neighbours at another place"),
          .measure = [] { return misplaced(hexagonal(box, D)); },
          .sabotaged = [] { return misplaced(rows_at_one_spacing()); }},
    Claim{.id = "hexagonal.area_per_point",
          .source = {Paper::plumbline, "docstring of hexagonal"},
          .says = "each point has the area √3 D²/2",
          .bound = at_most(1e-14, "480 points in 20 · 12 periods of D × √3 D: 10 roundings"),
          .measure = [] { return area_error(hexagonal(box, D)); },
          .sabotaged = [] { return area_error(rows_at_one_spacing()); }},
};
}  // namespace
}  // namespace hexagonal_claims
