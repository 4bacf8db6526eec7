#include "solver/neighbours/endless_grid.h"

#include "verification/framework/registry.h"

#include <map>
#include <set>

namespace endless_grid_claims {
namespace {
using namespace plumbline;
using namespace verification;

const EndlessGrid<3, OpenSpace<3>> grid(OpenSpace<3>{}, 0.25);

/// Points of a line from −10 to 10, 100 to each cell; the most / the least that a cell gets.
template <class CellOf> double widest_over_narrowest(CellOf cell) {
    std::map<std::int64_t, int> points;
    for (int k = -4000; k < 4000; ++k) ++points[cell((k + 0.5) * 0.0025)];
    const auto [least, most] =
        std::ranges::minmax_element(points, {}, [](const auto& entry) { return entry.second; });
    return static_cast<double>(most->second) / least->second;
}
Cell<3> printed_cell(const Vec<3>& x) { return grid.cell({x[0], x[2], x[2]}); }
constinit Mutant eq_42_with_z_twice{38, "Eq. 42 with z for y", "cell of a point"};
Cell<3> cell_of(const Vec<3>& x) {
    return eq_42_with_z_twice.applied() ? printed_cell(x) : grid.cell(x);
}
double by_floor() {
    return widest_over_narrowest([](double x) { return cell_of({x, 0, 0})[0]; });
}
double by_truncation() {
    return widest_over_narrowest([](double x) { return static_cast<std::int64_t>(x / 0.25); });
}

/// Cells told apart / cells there are, for the centres of 10 × 10 × 10 cells.
template <class CellOf> double cells_told_apart(CellOf cell) {
    std::set<Cell<3>> cells;
    const CellRange<3> all{{-5, -5, -5}, {4, 4, 4}};
    all.for_each([&](const Cell<3>& c) {
        Vec<3> centre;
        for (int a = 0; a < 3; ++a) centre[a] = (static_cast<double>(c[a]) + 0.5) * 0.25;
        cells.insert(cell(centre));
    });
    return static_cast<double>(cells.size()) / all.count();
}
/// Of 2000 pairs of points k spacings from the origin and closer than the radius, those whose second
/// point is in none of the cells around the first.
/// The last cell that is visited: as the grid says, that of the query, or one less than the grid says.
enum class Last { around, own, one_less };
double missed_far_out(double spacings, Last visited) {
    int missed = 0;
    constexpr double radius = 0.1;
    const EndlessGrid<1, OpenSpace<1>> line(OpenSpace<1>{}, radius);
    double x = spacings * radius;
    for (int k = 0; k < 2000; ++k, x = std::nextafter(x, HUGE_VAL)) {
        double y = x + radius;
        while (!(y - x < radius)) y = std::nextafter(y, x);
        const auto range = line.around(Vec<1>(x), radius);
        const std::int64_t last = visited == Last::around ? range.last[0]
                                  : visited == Last::own  ? line.cell(Vec<1>(x))[0]
                                                          : range.last[0] - 1;
        if (line.cell(Vec<1>(y))[0] > last) ++missed;
    }
    return missed;
}

const Register claims_of_endless_grid{
    &eq_42_with_z_twice,
    Claim{
        .id = "endless_grid.cells_are_equally_wide",
        .source = {Paper::adams2009, "Eq. 42"},
        .says = "⌊x/d⌋ makes cells of one width on both sides of the origin; truncation would not",
        .bound = between(1.0, 1.0, "100 points a cell, none near a border"),
        .measure = by_floor,
        .sabotaged = by_truncation},
    Claim{.id = "endless_grid.cells_are_told_apart_along_every_axis",
          .source = {Paper::adams2009, "Eq. 42"},
          .says = "(⌊x/d⌋, ⌊y/d⌋, ⌊z/d⌋) has a value of its own for each cell",
          .bound = between(1.0, 1.0, "1000 cells have 1000 numbers"),
          .measure = [] { return cells_told_apart(cell_of); },
          .sabotaged = [] { return cells_told_apart(printed_cell); },
          .erratum = 38},
    Claim{.id = "endless_grid.rounding_hides_no_cell",
          .source = {Paper::plumbline, "docstring of EndlessGrid"},
          .says = "a neighbour 1e9 spacings from the origin is in a cell around the query",
          .bound = at_most(0.0, "the interval is widened outwards by more than its rounding"),
          .measure = [] { return missed_far_out(1e9, Last::around); },
          .sabotaged = [] { return missed_far_out(1e9, Last::own); }},
    Claim{
        .id = "endless_grid.right_beyond_its_last_cell",
        .source = {Paper::plumbline, "docstring of EndlessGrid"},
        .says = "a neighbour 1e16 and more spacings from the origin is in the outermost cell",
        .bound = at_most(0.0, "clamping is monotonic"),
        .measure =
            [] { return missed_far_out(1e16, Last::around) + missed_far_out(1e30, Last::around); },
        .sabotaged = [] { return missed_far_out(1e30, Last::one_less); }},
};
}  // namespace
}  // namespace endless_grid_claims
