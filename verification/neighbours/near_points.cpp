#include "solver/neighbours/near_points.h"

#include "solver/neighbours/candidates.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/near_tests.h"

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
};
}  // namespace
