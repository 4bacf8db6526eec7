#include "solver/neighbours/space.h"

#include "solver/foundation/random.h"
#include "solver/particles/lattice.h"
#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"

namespace space_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> Real50 exact_square(const Vec<Dim>& a, const Vec<Dim>& b) {
    Real50 total = 0;
    for (int axis = 0; axis < Dim; ++axis) {
        const Real50 d = Real50(a[axis]) - Real50(b[axis]);
        total += d * d;
    }
    return total;
}

/// A decision rule: is b closer to a than r?
using Rule3 = bool (*)(const Vec<3>& a, const Vec<3>& b, double r);
bool by_difference(const Vec<3>& a, const Vec<3>& b, double r) {
    return squared_distance(OpenSpace<3>{}, a, b) < r * r;
}
bool exactly(const Vec<3>& a, const Vec<3>& b, double r) {
    return exact_square(a, b) < Real50(r) * Real50(r);
}
/// The tempting expansion, which saves subtractions and cancels.
bool by_expansion(const Vec<3>& a, const Vec<3>& b, double r) {
    return a.dot(a) + b.dot(b) - 2.0 * a.dot(b) < r * r;
}

struct WrongDecisions {
    int number = 0;
    double farthest = 0.0;  // max |‖a − b‖ / r − 1| over them
};

/// Of 20000 pairs a few units in the last place around the radius.
WrongDecisions wrong_decisions(Rule3 closer) {
    Random random(11);
    WrongDecisions wrong;
    for (int k = 0; k < 20000; ++k) {
        const Vec<3> a(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
        Vec<3> direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const Vec<3> b = a + 0.3 * random.uniform(0.5, 1.0) * direction.normalized();
        double r = std::sqrt(exact_square(a, b).convert_to<double>());
        for (int ulps = k % 5 - 2; ulps != 0; ulps += ulps < 0 ? 1 : -1)
            r = std::nextafter(r, ulps < 0 ? 0.0 : HUGE_VAL);
        const Real50 square = exact_square(a, b), limit = Real50(r) * Real50(r);
        if (closer(a, b, r) == (square < limit)) continue;
        ++wrong.number;
        wrong.farthest =
            std::max(wrong.farthest, std::abs((sqrt(square) / Real50(r) - 1).convert_to<double>()));
    }
    return wrong;
}

/// Wrong decisions among all pairs of a lattice, whose many ties are at exactly the radius.
double wrong_on_lattice(double spacing) {
    const Points<3> points = lattice(unit_box<3>(), spacing);
    const double r = 2.0 * spacing;
    int wrong = 0;
    for (std::size_t i = 0; i < points.size(); i += 7)
        for (const Vec<3>& x : points)
            if (std::abs(x[0] - points[i][0]) < 1.5 * r)
                wrong += by_difference(points[i], x, r) !=
                         (exact_square(points[i], x) < Real50(r) * Real50(r));
    return wrong;
}

const PeriodicBox<2> box({-1.0, 0.0}, {2.0, 0.7});
Vec<2> in_box(Random& random) { return {random.uniform(-1.0, 2.0), random.uniform(0.0, 0.7)}; }

/// |distance − exact distance of the nearest images| over 5000 pairs, in units of 2⁻⁵³ of the box.
double periodic_error(bool wrap_first_axis_only) {
    Random random(12);
    double worst = 0.0;
    for (int k = 0; k < 5000; ++k) {
        const Vec<2> a = in_box(random), b = in_box(random);
        Real50 nearest = 1e9;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const Real50 x = Real50(a[0]) - Real50(b[0]) + 3 * i;
                const Real50 y = Real50(a[1]) - Real50(b[1]) + (Real50(0.7)) * j;
                nearest = std::min<Real50>(nearest, sqrt(x * x + y * y));
            }
        double found = std::sqrt(squared_distance(box, a, b));
        if (wrap_first_axis_only) found = std::hypot(box.difference(a[0], b[0], 0), a[1] - b[1]);
        worst = std::max(worst, std::abs(Real50(found - nearest).convert_to<double>()));
    }
    return worst / (0x1p-53 * 3.0);
}

/// Boxes whose computed gap exceeds the computed distance of a point in them, of 20000.
template <class Space> double gaps_too_wide(const Space& space, double widening) {
    Random random(13);
    int wide = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec<2> q = in_box(random), a = in_box(random), b = in_box(random);
        const Vec<2> low = a.cwiseMin(b), high = a.cwiseMax(b);
        const Vec<2> corner = k % 2 == 0 ? Vec<2>(low[0], high[1]) : Vec<2>(high[0], low[1]);
        for (int axis = 0; axis < 2; ++axis)
            wide += widening * space.gap(q[axis], low[axis], high[axis], axis) >
                    std::abs(space.difference(q[axis], corner[axis], axis));
    }
    return wide;
}

const Register claims_of_space{
    Claim{.id = "space.decision_is_exact_away_from_ties",
          .source = {Paper::plumbline, "docstring of squared_distance"},
          .says = "no pair is decided wrongly unless |‖a − b‖ / r − 1| < 7 · 2⁻⁵⁴",
          .bound = at_most(7 * 0x1p-54,
                           "the rounded square has 5 roundings of 2⁻⁵³, r · r has one; half of "
                           "their sum for the distance, and 2⁻⁵⁴ for products of roundings"),
          .measure = [] { return wrong_decisions(by_difference).farthest; },
          .sabotaged = [] { return wrong_decisions(by_expansion).farthest; }},
    Claim{.id = "space.rounding_decides_some_near_ties_wrongly",
          .source = {Paper::plumbline, "docstring of squared_distance"},
          .says =
              "within 2 units in the last place of the radius some pairs are decided wrongly, so "
              "the guarantee says no more than is needed",
          .bound = at_least(1.0, "20000 pairs within 2 units"),
          .measure = [] { return wrong_decisions(by_difference).number; },
          .sabotaged = [] { return wrong_decisions(exactly).number; }},
    Claim{.id = "space.lattice_ties_are_exact",
          .source = {Paper::plumbline, "docstring of squared_distance"},
          .says = "on a lattice of spacing 1/16 the sites at exactly r are no neighbours: 0 wrong",
          .bound = at_most(0.0, "multiples of 1/32 below 1: differences and squares are exact"),
          .measure = [] { return wrong_on_lattice(1.0 / 16.0); },
          .sabotaged = [] { return wrong_on_lattice(0.1); }},
    Claim{.id = "space.periodic_distance_is_to_the_nearest_image",
          .source = {Paper::plumbline, "docstring of PeriodicBox"},
          .says = "‖a − b‖ in a periodic box is the least over all images, to rounding of the box",
          .bound = at_most(4.0,
                           "one rounding of at most 2⁻⁵³ of the edge along each axis, those of "
                           "the sum and of the square root, with the edge 0.7 itself rounded"),
          .measure = [] { return periodic_error(false); },
          .sabotaged = [] { return periodic_error(true); }},
    Claim{.id = "space.gap_is_a_lower_bound",
          .source = {Paper::plumbline, "docstring of OpenSpace"},
          .says = "the gap to a box never exceeds the distance of a point in it, as computed",
          .bound = at_most(0.0, "rounding is monotonic"),
          .measure = [] { return gaps_too_wide(OpenSpace<2>{}, 1.0) + gaps_too_wide(box, 1.0); },
          .sabotaged = [] { return gaps_too_wide(OpenSpace<2>{}, 1.0 + 0x1p-52); }},
};
}  // namespace
}  // namespace space_claims
