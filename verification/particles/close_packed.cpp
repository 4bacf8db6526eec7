#include "solver/particles/close_packed.h"

#include "solver/particles/hexagonal.h"
#include "verification/framework/registry.h"
#include "verification/particles/shells.h"

namespace close_packed_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double D = 0.1;
const Box<3> box{{0.0, 0.0, 0.0}, Vec<3>::Constant(7 * std::sqrt(2.0) * D)};

double misplaced(const Points<3>& points) {
    return misplaced_neighbours(points, box, D,
                                {{1, 12},
                                 {std::sqrt(2.0), 6},
                                 {std::sqrt(3.0), 24},
                                 {2, 12},
                                 {std::sqrt(5.0), 24},
                                 {std::sqrt(6.0), 8}});
}
double volume_error_of(const Points<3>& points) {
    return volume_error(points, box, D * D * D / std::sqrt(2.0));
}

/// Hexagonal close packing: as dense, with 12 nearest neighbours, too, but layers A B A B, not A B C.
Points<3> stacked_in_two_layers() {
    const Box<2> plane{{0.0, 0.0}, {box.high[0], box.high[1]}};
    const Points<2> layer = hexagonal(plane, D);
    const double height = std::sqrt(2.0 / 3.0) * D;
    Points<3> points;
    for (int k = 0; k < whole_cells(box.high[2], height); ++k)
        for (const Vec<2>& x : layer)
            points.emplace_back(x[0], x[1] + (k % 2) * D / std::sqrt(3.0), (k + 0.5) * height);
    return points;
}
/// Eq. 1 without its condition that l + m + n is even.
Points<3> all_sites() { return lattice(box, D / std::sqrt(2.0)); }

const Register claims_of_close_packed{
    Claim{.id = "close_packed.shells",
          .source = {Paper::wicke2006, "Eq. 1"},
          .says = "12, 6, 24, 12, 24, 8 neighbours at D √(1, 2, 3, 4, 5, 6)",
          .bound = at_most(0, "a count of neighbours at another place"),
          .measure = [] { return misplaced(close_packed(box, D)); },
          .sabotaged = [] { return misplaced(stacked_in_two_layers()); }},
    Claim{.id = "close_packed.volume_per_point",
          .source = {Paper::plumbline, "docstring of close_packed"},
          .says = "each point has the volume D³/√2",
          .bound = at_most(1e-14, "1372 points in 7³ periods of √2 D: 12 roundings"),
          .measure = [] { return volume_error_of(close_packed(box, D)); },
          .sabotaged = [] { return volume_error_of(all_sites()); }},
};
}  // namespace
}  // namespace close_packed_claims
