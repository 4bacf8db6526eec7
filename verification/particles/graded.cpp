#include "solver/particles/graded.h"

#include "verification/framework/registry.h"

namespace graded_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double contrast = 100.0;
constexpr Index n = 20000;
const Box<2> box{{-1.0, 0.0}, {3.0, 0.5}};

double share_below(double u) { return (std::pow(contrast, u) - 1) / (contrast - 1); }

/// n · max over 99 places u of |share of the points below u − exact share|.
double worst_share(const Points<2>& points) {
    double worst = 0.0;
    for (int k = 1; k < 100; ++k) {
        const double u = k / 100.0;
        const auto below = std::ranges::count_if(
            points, [&](const Vec<2>& x) { return x[0] < box.low[0] + u * box.size()[0]; });
        worst = std::max(worst, std::abs(static_cast<double>(below) - n * share_below(u)));
    }
    return worst;
}
/// The density grows linearly from 1 to the contrast.
Points<2> linearly_graded() {
    Points<2> points = halton(unit_box<2>(), n);
    for (Vec<2>& u : points) {
        const double c = contrast - 1;
        u[0] = (std::sqrt(1 + u[0] * c * (2 + c)) - 1) / c;
        u = box.at(u);
    }
    return points;
}

const Register claims_of_graded{
    Claim{
        .id = "graded.share_of_points",
        .source = {Paper::plumbline, "docstring of graded"},
        .says = "(contrastᵘ − 1)/(contrast − 1) of the points lie below the fraction u of the edge",
        .bound = at_most(9.7,
                         "points off: n D* of the base 2 sequence, at most 1 + ln n/(2 ln 2) "
                         "+ 3/2 for n = 20000 (Niederreiter 1992, Theorem 3.6)"),
        .measure = [] { return worst_share(graded(box, n, contrast)); },
        .sabotaged = [] { return worst_share(linearly_graded()); }},
    Claim{.id = "graded.contrast_one_is_halton",
          .source = {Paper::plumbline, "docstring of graded"},
          .says = "contrast 1 moves no point; contrast 1 + 1e-9 moves none by more than that [m]",
          .bound = at_most(1e-9,
                           "|∂u/∂contrast| = u(1 − u)/2 ≤ 1/8, times the edge of 4 m; rounding "
                           "1e-16/1e-9 of log1p is below 1 % of it"),
          .measure =
              [] {
                  const auto expected = halton(box, n), one = graded(box, n, 1.0),
                             nearly = graded(box, n, 1.0 + 1e-9);
                  double worst = 0.0;
                  for (Index i = 0; i < n; ++i)
                      worst = std::max({worst, one[i] == expected[i] ? 0.0 : HUGE_VAL,
                                        (nearly[i] - expected[i]).norm()});
                  return worst;
              },
          .sabotaged =
              [] {
                  const auto expected = halton(box, n);
                  double worst = 0.0;  // log and exp of 1 + tiny numbers, not log1p
                  for (const Vec<2>& x : expected) {
                      const double u = (x[0] - box.low[0]) / 4, c = 1.0 + 1e-9;
                      const double moved = std::log(1 + u * (c - 1)) / std::log(c);
                      worst = std::max(worst, 4 * std::abs(moved - u));
                  }
                  return worst;
              }},
};
}  // namespace
}  // namespace graded_claims
