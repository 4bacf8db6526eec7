#include "solver/particles/box.h"

#include "solver/particles/samplings.h"
#include "verification/framework/registry.h"

namespace box_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Far from the origin, so that coordinates are rounded to 1.2e-10 [m], and of edges 0.5 … 1.5.
template <int Dim> Box<Dim> far_box() {
    Vec<Dim> low, size;
    for (int d = 0; d < Dim; ++d) low[d] = 1e6 * (d - 0.7), size[d] = 0.5 + 0.5 * d;
    return {low, low + size};
}

template <class At> double fractions_that_leave(At at) {
    double outside = 0;
    for (int k = 1; k <= 60; ++k) {
        const Box<1> box{Vec<1>(1.0), Vec<1>(1.0 + std::ldexp(1.0, 1 - std::min(k, 53)))};
        const Vec<1> x = at(box, Vec<1>(1.0 - 0x1p-53));
        outside += !box.contains(x);
    }
    return outside;
}

template <int Dim> double points_outside() {
    double outside = 0;
    const Box<Dim> box = far_box<Dim>();
    for (const Sampling<Dim>& sampling : samplings<Dim>())
        for (const std::uint64_t seed : {1, 2})
            for (const Vec<Dim>& x : sampling.fill(box, 500, seed)) outside += !box.contains(x);
    return outside;
}

const Register claims_of_box{
    Claim{.id = "box.at_stays_inside",
          .source = {Paper::plumbline, "docstring of Box"},
          .says = "the largest fraction below 1 gives a point below the high face, even where "
                  "low + u · size is rounded to it",
          .bound = at_most(0, "of 60 boxes down to one unit in the last place"),
          .measure =
              [] {
                  return fractions_that_leave(
                      [](const Box<1>& box, const Vec<1>& u) { return box.at(u); });
              },
          .sabotaged =
              [] {
                  return fractions_that_leave([](const Box<1>& box, const Vec<1>& u) -> Vec<1> {
                      return box.low + u.cwiseProduct(box.size());
                  });
              }},
    Claim{.id = "box.holds_all_samplings",
          .source = {Paper::plumbline, "docstring of samplings"},
          .says = "every sampling, in 1, 2 and 3 dimensions, fills the box and nothing else",
          .bound = at_most(0, "a count of points outside [low, high)"),
          .measure = [] { return points_outside<1>() + points_outside<2>() + points_outside<3>(); },
          .sabotaged =
              [] {
                  double outside = 0;
                  for (const Vec<2>& x : lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, 0.1))
                      outside += !unit_box<2>().contains(x + Vec<2>::Constant(0.05));
                  return outside;
              }},
};
}  // namespace
}  // namespace box_claims
