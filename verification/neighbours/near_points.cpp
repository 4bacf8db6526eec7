#include "solver/neighbours/near_points.h"

#include "solver/neighbours/candidates.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/near_tests.h"

namespace near_points_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Candidates that the plain functions find, or do not find, against squared_distance. A mistake to
/// be caught: the differences of open space in a periodic box.
template <class Real, class Space, int Dim>
double wrong_plainly(const Space& space, bool as_if_open) {
    const auto plain =
        near_functions<Real>(Instructions::plain, Dim, Space::is_periodic && !as_if_open);
    double wrong = 0.0;
    for (std::size_t n = 0; n < 100; ++n) {
        const NearCase<Real, Dim> drawn(n);
        std::vector<Index> expected, found(n + candidates_per_step);
        for (std::size_t k = 0; k < n; ++k)
            if (squared_distance(space, drawn.centre, drawn.point(k)) < drawn.squared_radius)
                expected.push_back(drawn.candidates.id()[k]);
        const auto test = drawn.test(space, 0);
        found.resize(plain.select(test, found.data()));
        wrong += found != expected || plain.mark(test, nullptr) != found.size();
    }
    return wrong;
}
/// One of 27 points of a box: along each axis an end, the other, or the coordinate in it that is nearest
/// to x.
template <class Point>
Point point_of_box(int number, const Point& low, const Point& high, Point x) {
    for (int axis = 0; axis < x.size(); ++axis, number /= 3)
        x[axis] = number % 3 == 0   ? low[axis]
                  : number % 3 == 1 ? high[axis]
                                    : std::clamp(x[axis], low[axis], high[axis]);
    return x;
}
/// Candidates that are not kept though they are near a point of the box, or not with their coordinates.
/// A mistake to be caught: of the box only a corner is seen.
template <class Real, class Space, int Dim> double lost(const Space& space, bool as_if_a_corner) {
    const auto plain = near_functions<Real>(Instructions::plain, Dim, Space::is_periodic);
    using Point = VecOf<Real, Dim>;
    const Point low = Point::Constant(Real(-0.3)), high = Point::Constant(Real(0.2));
    double wrong = 0.0;
    for (std::size_t n = 0; n < 100; ++n) {
        const NearCase<Real, Dim> drawn(n);
        auto all = drawn.candidates;
        all.keep_near(plain, space, as_if_a_corner ? high : low, high, drawn.squared_radius);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const Point x = drawn.point(k);
            if (kept < all.size() && all.id()[kept] == drawn.candidates.id()[k]) {
                for (int axis = 0; axis < Dim; ++axis) wrong += all.x(axis)[kept] != x[axis];
                ++kept;
                continue;
            }
            for (int q = 0; q < 27; ++q)
                wrong += squared_distance(space, point_of_box(q, low, high, x), x) <
                         drawn.squared_radius;
        }
        wrong += kept != all.size();
    }
    return wrong;
}
double lost_of_all(bool as_if_a_corner) {
    const PeriodicBox<3> box(Vec<3>::Constant(-0.8), Vec<3>::Constant(0.8));
    return lost<double, OpenSpace<3>, 3>({}, as_if_a_corner) +
           lost<float, OpenSpace<2>, 2>({}, as_if_a_corner) +
           lost<float, PeriodicBox<3>, 3>(box, as_if_a_corner);
}
double wrong_of_all(bool as_if_open) {
    const PeriodicBox<3> box(Vec<3>::Constant(-0.8), Vec<3>::Constant(0.8));
    const PeriodicBox<2> square(Vec<2>::Constant(-0.8), Vec<2>::Constant(0.8));
    return wrong_plainly<double, OpenSpace<3>, 3>({}, as_if_open) +
           wrong_plainly<float, OpenSpace<2>, 2>({}, as_if_open) +
           wrong_plainly<double, PeriodicBox<2>, 2>(square, as_if_open) +
           wrong_plainly<float, PeriodicBox<3>, 3>(box, as_if_open);
}

const Register claims_of_near_points{
    Claim{.id = "near_points.plain_form_is_squared_distance",
          .source = {Paper::plumbline, "docstring of NearTest"},
          .says =
              "candidates are listed iff squared_distance puts them inside the radius, in single "
              "and double precision, in open space and in a periodic box",
          .bound = at_most(0.0, "the same operations in the same order, without contraction"),
          .measure = [] { return wrong_of_all(false); },
          .sabotaged = [] { return wrong_of_all(true); }},
    Claim{.id = "near_points.keeps_what_is_near_the_box",
          .source = {Paper::plumbline, "docstring of BoxTest"},
          .says =
              "no candidate is lost that is near a corner of the box, or near the point of it, its "
              "faces or its edges, that is nearest",
          .bound = at_most(0.0, "differences, squares and sums are rounded monotonically"),
          .measure = [] { return lost_of_all(false); },
          .sabotaged = [] { return lost_of_all(true); }},
};
}  // namespace
}  // namespace near_points_claims
