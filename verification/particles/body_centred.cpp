#include "solver/particles/body_centred.h"

#include "verification/framework/registry.h"
#include "verification/particles/shells.h"

namespace body_centred_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double D = 0.1;
const Box<3> box{{0.0, 0.0, 0.0}, Vec<3>::Constant(8 * 2 / std::sqrt(3.0) * D)};

/// Of the two simple cubic lattices that make it, the one.
Points<3> without_centres() {
    return cell_centres<3>(box, Vec<3>::Constant(D / std::sqrt(3.0)), [](const auto& k) {
        return k[0] % 2 == 0 && k[1] % 2 == 0 && k[2] % 2 == 0;
    });
}

double misplaced(const Points<3>& points) {
    return misplaced_neighbours(
        points, box, D,
        {{1, 8}, {std::sqrt(4.0 / 3), 6}, {std::sqrt(8.0 / 3), 12}, {std::sqrt(11.0 / 3), 24}});
}
double volume_error_of(const Points<3>& points) {
    return volume_error(points, box, 4 * D * D * D / (3 * std::sqrt(3.0)));
}

const Register claims_of_body_centred{
    Claim{.id = "body_centred.shells",
          .source = {Paper::plumbline, "docstring of body_centred"},
          .says = "8, 6, 12, 24 neighbours at D √(3, 4, 8, 11)/√3",
          .bound = at_most(0, "a count of neighbours at another place"),
          .measure = [] { return misplaced(body_centred(box, D)); },
          .sabotaged = [] { return misplaced(without_centres()); }},
    Claim{.id = "body_centred.volume_per_point",
          .source = {Paper::plumbline, "docstring of body_centred"},
          .says = "each point has the volume 4 D³/(3√3)",
          .bound = at_most(1e-14, "1024 points in 8³ periods of 2D/√3: 12 roundings"),
          .measure = [] { return volume_error_of(body_centred(box, D)); },
          .sabotaged = [] { return volume_error_of(without_centres()); }},
};
}  // namespace
}  // namespace body_centred_claims
