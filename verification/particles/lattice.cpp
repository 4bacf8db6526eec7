#include "solver/particles/lattice.h"

#include "verification/framework/registry.h"
#include "verification/particles/shells.h"

namespace lattice_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double spacing = 0.1;

double whole_cells_without_tolerance(double length, double step) {
    return std::floor(length / step);
}

/// How many lengths n/10 are not found to hold n cells of 0.1; n/10 and 0.1 are rounded.
template <class Count> double wrong_counts(Count count) {
    double wrong = 0;
    for (int n = 1; n <= 1000; ++n) wrong += count(n / 10.0, spacing) != n;
    return wrong;
}

const Box<2> square{{-0.55, 0.2}, {0.55, 1.3}};
const Box<3> cube{{-0.55, 0.2, 7.0}, {0.55, 1.3, 8.1}};

double wrong_in_plane() {
    return misplaced_neighbours(lattice(square, spacing), square, spacing,
                                {{1, 4}, {std::sqrt(2.0), 4}, {2, 4}, {std::sqrt(5.0), 8}});
}
double wrong_in_space() {
    return misplaced_neighbours(
        lattice(cube, spacing), cube, spacing,
        {{1, 6}, {std::sqrt(2.0), 12}, {std::sqrt(3.0), 8}, {2, 6}, {std::sqrt(5.0), 24}});
}
/// n points spread over the n cells so that the first and the last lie on the faces.
template <int Dim> double wrong_if_stretched_to_the_faces(const Box<Dim>& box) {
    Points<Dim> points = lattice(box, spacing);
    const Vec<Dim> middle = 0.5 * (box.low + box.high);
    for (Vec<Dim>& x : points) x = middle + 11.0 / 10.0 * (x - middle);
    return misplaced_neighbours(points, box, spacing, {{1, 2 * Dim}});
}

/// `both_ends`: points on both faces, one more than there are cells.
double volume_error_in_1d(bool both_ends) {
    const Box<1> line{Vec<1>(-2.0), Vec<1>(1.0)};
    Points<1> points = lattice(line, spacing);
    if (both_ends) points.push_back(line.high);
    return volume_error(points, line, spacing);
}
double volume_error_in_space() {
    return volume_error(lattice(cube, spacing), cube, std::pow(spacing, 3));
}
double volume_error_with_points_on_both_faces() {
    const Box<3> wider{cube.low, cube.high + Vec<3>::Constant(spacing)};
    return volume_error(lattice(wider, spacing), cube, std::pow(spacing, 3));
}

double distance_of_mean_from_middle(const Vec<3>& moved_by) {
    Vec<3> mean = Vec<3>::Zero();
    const Points<3> points = lattice(cube, spacing);
    for (const Vec<3>& x : points) mean += (x + moved_by) / static_cast<double>(points.size());
    return (mean - 0.5 * (cube.low + cube.high)).norm();
}
double off_centre() { return distance_of_mean_from_middle(Vec<3>::Zero()); }
double off_centre_at_low_corners() {
    return distance_of_mean_from_middle(Vec<3>::Constant(-0.5 * spacing));
}

const Register claims_of_lattice{
    Claim{.id = "lattice.counts_what_rounding_took",
          .source = {Paper::plumbline, "docstring of whole_cells"},
          .says = "a box n cells long has n cells, although n/10 and 0.1 are rounded",
          .bound = at_most(0, "of 1000 lengths; the quotient is off by 2 ulp, 1e-9 is 1e6 ulp"),
          .measure = [] { return wrong_counts(whole_cells); },
          .sabotaged = [] { return wrong_counts(whole_cells_without_tolerance); }},
    Claim{.id = "lattice.shells_2d",
          .source = {Paper::plumbline, "docstring of lattice"},
          .says = "4, 4, 4, 8 neighbours at 1, √2, 2, √5 spacings",
          .bound = at_most(0, "a count of neighbours at another place"),
          .measure = wrong_in_plane,
          .sabotaged = [] { return wrong_if_stretched_to_the_faces(square); }},
    Claim{.id = "lattice.shells_3d",
          .source = {Paper::plumbline, "docstring of lattice"},
          .says = "6, 12, 8, 6, 24 neighbours at 1, √2, √3, 2, √5 spacings",
          .bound = at_most(0, "a count of neighbours at another place"),
          .measure = wrong_in_space,
          .sabotaged = [] { return wrong_if_stretched_to_the_faces(cube); }},
    Claim{.id = "lattice.volume_per_point_1d",
          .source = {Paper::plumbline, "docstring of lattice"},
          .says = "each point has the length of one spacing",
          .bound = at_most(1e-15, "30 · 0.1 / 3, each rounded once: 4 roundings of 1.1e-16"),
          .measure = [] { return volume_error_in_1d(false); },
          .sabotaged = [] { return volume_error_in_1d(true); }},
    Claim{.id = "lattice.volume_per_point_3d",
          .source = {Paper::plumbline, "docstring of lattice"},
          .says = "each point has the volume of a cube of one spacing",
          .bound = at_most(1e-14,
                           "the edge 8.1 − 7 is off by half an ulp of 8.1, 8e-16 of 1.1; the "
                           "two others by less; and 6 roundings of 1.1e-16"),
          .measure = volume_error_in_space,
          .sabotaged = volume_error_with_points_on_both_faces},
    Claim{.id = "lattice.is_centred",
          .source = {Paper::plumbline, "docstring of cell_centres"},
          .says = "points are the middles of cells, so their mean is the middle of the box [m]",
          .bound = at_most(1e-12, "1331 additions to a sum up to 8: 1331 · 8 · 1.1e-16"),
          .measure = off_centre,
          .sabotaged = off_centre_at_low_corners},
};
}  // namespace
}  // namespace lattice_claims
