#include "solver/particles/poisson_disc.h"

#include "solver/particles/halton.h"
#include "solver/particles/uniform_random.h"
#include "verification/framework/registry.h"

namespace poisson_disc_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> double nearest_squared(const Points<Dim>& points, const Vec<Dim>& x) {
    double nearest = HUGE_VAL;
    for (const Vec<Dim>& p : points) nearest = std::min(nearest, (p - x).squaredNorm());
    return nearest;
}

/// Pairs closer than the distance, compared as the method does: without the root.
template <int Dim> double pairs_too_close(const Points<Dim>& points, double distance) {
    double pairs = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            pairs += (points[i] - points[j]).squaredNorm() < distance * distance;
    return pairs;
}
/// Places that have no point within the distance, of 20000.
template <int Dim> double places_left_over(const Points<Dim>& points, double distance) {
    double left = 0;
    for (const Vec<Dim>& x : halton(unit_box<Dim>(), 20000))
        left += nearest_squared(points, x) >= distance * distance;
    return left;
}

/// Darts at random places until `patience` of them in a row have missed.
template <int Dim> Points<Dim> until_patience_ends(double distance, int patience) {
    Random random(1);
    Points<Dim> points;
    for (int missed = 0; missed < patience;) {
        const Vec<Dim> x = random_point(unit_box<Dim>(), random);
        const bool free = nearest_squared(points, x) >= distance * distance;
        if (free) points.push_back(x);
        missed = free ? 0 : missed + 1;
    }
    return points;
}
/// Every dart is compared with the points of its own cell and of those that touch it only.
Points<2> compared_with_adjacent_cells_only(double distance) {
    const double edge = distance / std::sqrt(2.0);
    Random random(1);
    Points<2> points;
    for (int dart = 0; dart < 20000; ++dart) {
        const Vec<2> x = random_point(unit_box<2>(), random);
        const auto cell = [&](const Vec<2>& p) { return (p / edge).array().floor().eval(); };
        if (std::ranges::none_of(points, [&](const Vec<2>& p) {
                return (cell(p) - cell(x)).abs().maxCoeff() <= 1 &&
                       (p - x).squaredNorm() < distance * distance;
            }))
            points.push_back(x);
    }
    return points;
}

constexpr double r1 = 1.0 / 20000, r2 = 0.03, r3 = 0.12;

/// (points − mean) / √(0.0382 · cars) for cars of length 1 on a road; Rényi's mean.
double deviation_from_renyi(double points) {
    constexpr double renyi = 0.7475979202534114;
    const double road = 1 / r1 + 1;  // a point is the middle of a car, which may reach over the end
    return (points - (renyi * (road + 1) - 1)) / std::sqrt(0.0382 * road);
}

const Register claims_of_poisson_disc{
    Claim{.id = "poisson_disc.keeps_the_distance_2d",
          .source = {Paper::literature, "Ebeida et al. 2012"},
          .says = "no two points of the plane are closer than the distance, not by one bit",
          .bound = at_most(0, "a count of pairs"),
          .measure = [] { return pairs_too_close(poisson_disc(unit_box<2>(), r2, 1), r2); },
          .sabotaged = [] { return pairs_too_close(compared_with_adjacent_cells_only(r2), r2); }},
    Claim{.id = "poisson_disc.keeps_the_distance_3d",
          .source = {Paper::literature, "Ebeida et al. 2012"},
          .says = "no two points of space are closer than the distance, not by one bit",
          .bound = at_most(0, "a count of pairs"),
          .measure = [] { return pairs_too_close(poisson_disc(unit_box<3>(), r3, 1), r3); },
          .sabotaged = [] { return pairs_too_close(uniform_random(unit_box<3>(), 400, 1), r3); }},
    Claim{.id = "poisson_disc.leaves_no_gap_2d",
          .source = {Paper::literature, "Ebeida et al. 2012"},
          .says = "every place of the plane has a point within the distance",
          .bound = at_most(0, "a count of 20000 places"),
          .measure = [] { return places_left_over(poisson_disc(unit_box<2>(), r2, 1), r2); },
          .sabotaged = [] { return places_left_over(until_patience_ends<2>(r2, 30), r2); }},
    Claim{.id = "poisson_disc.leaves_no_gap_3d",
          .source = {Paper::literature, "Ebeida et al. 2012"},
          .says = "every place of space has a point within the distance",
          .bound = at_most(0, "a count of 20000 places"),
          .measure = [] { return places_left_over(poisson_disc(unit_box<3>(), r3, 1), r3); },
          .sabotaged = [] { return places_left_over(until_patience_ends<3>(r3, 30), r3); }},
    Claim{.id = "poisson_disc.number_is_renyis",
          .source = {Paper::literature, "Rényi 1958"},
          .says =
              "on a line the number of points is that of cars parked at random, 0.7476 per length",
          .bound = between(-5, 5, "standard deviations; the variance is 0.0382 per length"),
          .measure =
              [] {
                  return deviation_from_renyi(
                      static_cast<double>(poisson_disc(unit_box<1>(), r1, 1).size()));
              },
          .sabotaged =
              [] {  // with gaps of 1 … 2 lengths at random, as if each place were tried once
                  Random random(1);
                  double n = 0;
                  for (double x = 0; x < 1; ++n) x += r1 * random.uniform(1, 2);
                  return deviation_from_renyi(n);
              }},
};
}  // namespace
}  // namespace poisson_disc_claims
