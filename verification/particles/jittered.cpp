#include "solver/particles/jittered.h"

#include "solver/particles/uniform_random.h"
#include "verification/framework/registry.h"

#include <algorithm>

namespace jittered_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double spacing = 0.02, jitter = 0.3;
const Box<2> box{{-0.5, 0.0}, {0.5, 1.0}};
const Box<3> cube = unit_box<3>();

/// The displacements from the lattice, all coordinates, in spacings.
std::vector<double> displacements(const Points<2>& points) {
    const Points<2> sites = lattice(box, spacing);
    std::vector<double> all;
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (int d = 0; d < 2; ++d) all.push_back((points[i][d] - sites[i][d]) / spacing);
    return all;
}
double largest_displacement(const Points<2>& points) {
    double largest = 0;
    for (const double u : displacements(points)) largest = std::max(largest, std::abs(u));
    return largest;
}
double variance_ratio(const Points<2>& points) {
    double squares = 0;
    const auto all = displacements(points);
    for (const double u : all) squares += u * u;
    return squares / static_cast<double>(all.size()) / (jitter * jitter / 3);
}

/// Moves of another range: to one side only.
Points<2> with_moves(double low, double high) {
    Points<2> points = lattice(box, spacing);
    Random random(5);
    for (Vec<2>& x : points)
        for (int d = 0; d < 2; ++d) x[d] += random.uniform(low, high) * spacing;
    return points;
}

/// Cells of the lattice that do not hold exactly one point.
double cells_without_one_point(const Points<3>& points) {
    constexpr int n = 10;
    std::vector<int> count(n * n * n);
    for (const Vec<3>& x : points) {
        const auto k = (x * n).cast<int>().eval();
        ++count[static_cast<std::size_t>((k[2] * n + k[1]) * n + k[0])];
    }
    return static_cast<double>(std::ranges::count_if(count, [](int c) { return c != 1; }));
}

const Register claims_of_jittered{
    Claim{
        .id = "jittered.stays_within_the_jitter",
        .source = {Paper::plumbline, "docstring of jittered"},
        .says = "no coordinate moves by more than jitter · spacing",
        .bound = between(0.999 * jitter, jitter*(1 + 1e-13),
                         "of 5000 moves none beyond, but for the rounding of coordinates, 1e-16 / "
                         "0.02; that all stay below 0.999 of it has the chance 0.999^5000 = 0.7 %"),
        .measure = [] { return largest_displacement(jittered(box, spacing, jitter, 5)); },
        .sabotaged = [] { return largest_displacement(with_moves(0, 2 * jitter)); }},
    Claim{
        .id = "jittered.is_uniform_within_the_jitter",
        .source = {Paper::plumbline, "docstring of jittered"},
        .says = "the moves have the variance of the uniform distribution, (jitter · spacing)²/3",
        .bound = between(1 - 0.0633, 1 + 0.0633,
                         "5 standard errors of 5000 squares of uniform numbers, 0.894/√5000 each"),
        .measure = [] { return variance_ratio(jittered(box, spacing, jitter, 5)); },
        .sabotaged = [] { return variance_ratio(with_moves(0, jitter * std::sqrt(1.2))); }},
    Claim{.id = "jittered.keeps_one_point_per_cell",
          .source = {Paper::plumbline, "docstring of jittered"},
          .says = "even the largest jitter, 1/2, leaves one point in each cell",
          .bound = at_most(0, "a move is less than half a cell"),
          .measure = [] { return cells_without_one_point(jittered(cube, 0.1, 0.5, 1)); },
          .sabotaged = [] { return cells_without_one_point(uniform_random(cube, 1000, 1)); }},
};
}  // namespace
}  // namespace jittered_claims
