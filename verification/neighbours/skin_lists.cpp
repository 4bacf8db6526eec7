#include "solver/neighbours/skin_lists.h"

#include "solver/foundation/random.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/clouds.h"
#include "verification/neighbours/packed_searches.h"
#include "verification/neighbours/searches.h"

namespace skin_lists_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Half of the points move along one axis, the others against it, so that pairs come closer as fast as
/// points can make them.
template <class Real, int Dim>
void move(std::vector<VecOf<Real, Dim>>& points, double step, Random& random) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i][0] += static_cast<Real>(i % 2 == 0 ? step : -step);
        points[i][1] += static_cast<Real>(random.uniform(-0.1, 0.1) * step);
    }
}

struct Missed {
    double missing = 0.0, wrong = 0.0;  // pairs, in the wide lists and in the exact ones
    int builds = 0;
};
/// 30 steps of 4 % of the skin: lists are built again about every 13th. A mistake to be caught: lists
/// last until a point has moved by the whole skin (a skin twice as wide, on the lists of half of it).
template <class Real, int Dim, class Space> Missed missed(const Space& space, bool whole_skin) {
    constexpr Index n = 600;
    const double radius = radius_for<Dim>(20.0, n), skin = 0.3 * radius, step = 0.04 * skin;
    auto points = in_precision<Real, Dim>(uniform_random(unit_box<Dim>(), n, 5));
    SkinLists<Dim, Space, Real> search(radius, skin, space);
    Random random(6);
    Missed total;
    for (int k = 0; k < 30; ++k) {
        if (!whole_skin || k % 25 == 0) total.builds += search.update(points) ? 1 : 0;
        BruteForce<Dim, Space, Real> oracle(space);
        oracle.build(points, radius);
        const auto expected = oracle.query(points);
        const auto wide = ascending(search.lists());
        for (Index i = 0; i < n; ++i)
            for (const Index j : expected.of(i))
                total.missing += std::ranges::binary_search(wide.of(i), j) ? 0.0 : 1.0;
        PackedLists exact;
        search.exact(exact);
        total.wrong += static_cast<double>(wrong_pairs(ascending(exact), expected));
        move<Real, Dim>(points, step, random);
        if constexpr (Space::is_periodic)
            for (auto& x : points) x = space.wrap(x.template cast<double>()).template cast<Real>();
    }
    return total;
}
template <class Real> Missed missed_in_open_space(bool whole_skin) {
    return missed<Real, 3>(OpenSpace<3>{}, whole_skin);
}
Missed missed_in_box(bool whole_skin) {
    return missed<double, 2>(PeriodicBox<2>(Vec<2>::Zero(), Vec<2>::Ones()), whole_skin);
}

const Source docstring{Paper::plumbline, "docstring of SkinLists"};
const Bound none = at_most(0.0,
                           "two points, each moved by less than skin / 2, came closer by less "
                           "than the skin by which the lists are wider");

const Register claims_of_skin_lists{
    Claim{.id = "skin_lists.miss_no_neighbour",
          .source = docstring,
          .says = "in 30 steps of 4 % of the skin, half of the points against the other half, no "
                  "neighbour is missing from the lists, in single and double precision",
          .bound = none,
          .measure =
              [] {
                  return missed_in_open_space<double>(false).missing +
                         missed_in_open_space<float>(false).missing;
              },
          .sabotaged = [] { return missed_in_open_space<double>(true).missing; }},
    Claim{.id = "skin_lists.miss_no_neighbour_periodic",
          .source = docstring,
          .says = "the same through the faces of a periodic box",
          .bound = none,
          .measure = [] { return missed_in_box(false).missing; },
          .sabotaged = [] { return missed_in_box(true).missing; }},
    Claim{.id = "skin_lists.exact_lists_equal_brute_force",
          .source = docstring,
          .says = "the same lists, filtered, are those of brute force at every step",
          .bound = at_most(0.0, "decided by the same floating-point expression as brute force"),
          .measure =
              [] {
                  return missed_in_open_space<double>(false).wrong +
                         missed_in_open_space<float>(false).wrong + missed_in_box(false).wrong;
              },
          .sabotaged = [] { return missed_in_open_space<double>(true).wrong; }},
    Claim{.id = "skin_lists.last_for_half_the_skin",
          .source = docstring,
          .says = "30 steps of 4 % of the skin (4.02 % with the sideways motion) need 3 builds: at "
                  "steps 0, 13 and 26",
          .bound = between(3.0, 3.0, "12 steps of 4.02 % stay below half of the skin, 13 do not"),
          .measure = [] { return missed_in_open_space<double>(false).builds; },
          .sabotaged = [] { return missed_in_open_space<double>(true).builds; }},
};
}  // namespace
}  // namespace skin_lists_claims
