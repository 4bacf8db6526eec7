#include "solver/neighbours/cell_frame.h"

#include "solver/foundation/random.h"
#include "verification/framework/registry.h"

namespace cell_frame_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Of 20000 pairs a little closer than the radius, somewhere in a box of so many radii, those that
/// seem to be more than `reach` cells apart.
double pairs_out_of_reach(double radii_across, double radius_factor, bool one_cell_only) {
    Random random(21);
    constexpr double radius = 0.1;
    const double edge = radii_across * radius;
    const Points<1> ends{Vec<1>(-0.3 * edge), Vec<1>(0.7 * edge)};
    const auto frame = CellFrame<1>::around(ends, radius);
    const std::int64_t reach = one_cell_only ? 1 : frame.reach(radius * radius_factor);
    double out = 0.0;
    for (int k = 0; k < 20000; ++k) {
        const double cell = std::floor(random.uniform() * radii_across);
        const double x = -0.3 * edge + (cell + random.uniform(-1e-6, 1e-6)) * radius;
        const double y = x + radius * radius_factor * (1.0 - 1e-9 * random.uniform());
        const std::int64_t a = frame.cell(x, 0), b = frame.cell(y, 0);
        if (y - x < radius * radius_factor && std::abs(a - b) > reach) ++out;
    }
    return out;
}

double periodic_pairs_out_of_reach(bool wrapped) {
    Random random(22);
    const PeriodicBox<1> box(Vec<1>(-1.0), Vec<1>(2.0));
    double out = 0.0;
    for (int k = 0; k < 20000; ++k) {
        const double radius = std::pow(10.0, random.uniform(-5.0, 0.17));
        const auto frame = CellFrame<1>::filling(box, radius);
        const double x = random.uniform(-1.0, 2.0);
        const double y = box.wrap(Vec<1>(x + radius * (1.0 - 1e-9)))[0];
        const std::int64_t cells = frame.cells(0), a = frame.cell(x, 0), b = frame.cell(y, 0);
        const std::int64_t apart = std::abs(a - b);
        const std::int64_t least = wrapped ? std::min(apart, cells - apart) : apart;
        if (std::abs(box.difference(x, y, 0)) < radius && least > frame.reach(radius)) ++out;
    }
    return out;
}

const Register claims_of_cell_frame{
    Claim{.id = "cell_frame.neighbours_are_in_adjacent_cells",
          .source = {Paper::plumbline, "docstring of CellFrame"},
          .says =
              "points closer than the radius are at most one cell apart, in boxes of 10, 1e6 and "
              "2e9 radii",
          .bound = at_most(0.0, "the error of a cell number is below 2⁻²¹, the margin 2⁻¹⁹"),
          .measure =
              [] {
                  return pairs_out_of_reach(10, 1.0, true) + pairs_out_of_reach(1e6, 1.0, true) +
                         pairs_out_of_reach(2e9, 1.0, true);
              },
          .sabotaged = [] { return pairs_out_of_reach(1e6, 2.5, true); }},
    Claim{
        .id = "cell_frame.reach_of_other_radii",
        .source = {Paper::plumbline, "docstring of CellFrame"},
        .says = "the same for radii of 0.3, 2.5 and 7 times that of the grid, with their own reach",
        .bound = at_most(0.0, "⌈radius / width⌉ with a margin for rounding"),
        .measure =
            [] {
                return pairs_out_of_reach(1e3, 0.3, false) + pairs_out_of_reach(1e3, 2.5, false) +
                       pairs_out_of_reach(1e6, 7.0, false);
            },
        .sabotaged = [] { return pairs_out_of_reach(1e3, 2.5, true); }},
    Claim{.id = "cell_frame.adjacent_through_the_faces",
          .source = {Paper::plumbline, "docstring of CellFrame"},
          .says = "in a periodic box, of any number of cells, the same holds modulo that number",
          .bound = at_most(0.0, "a whole number of cells fills the box"),
          .measure = [] { return periodic_pairs_out_of_reach(true); },
          .sabotaged = [] { return periodic_pairs_out_of_reach(false); }},
};
}  // namespace
}  // namespace cell_frame_claims
