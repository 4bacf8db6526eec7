#include "solver/particles/halton.h"

#include "solver/particles/uniform_random.h"
#include "verification/framework/registry.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>

namespace halton_claims {
namespace {
using namespace plumbline;
using namespace verification;
using Rational = boost::multiprecision::cpp_rational;

Rational exact_radical_inverse(std::uint64_t base, std::uint64_t i) {
    Rational sum = 0, weight = 1;
    for (; i > 0; i /= base) {
        weight /= base;
        sum += weight * (i % base);
    }
    return sum;
}
/// The usual loop; every step is rounded.
double summed_digit_by_digit(std::uint64_t base, std::uint64_t i) {
    double sum = 0.0, weight = 1.0;
    for (; i > 0; i /= base) {
        weight /= static_cast<double>(base);
        sum += weight * static_cast<double>(i % base);
    }
    return sum;
}

/// How often another double is nearer to the exact value, of the numbers 1 … 1000 and the largest.
template <class Inverse> double times_not_nearest(Inverse inverse) {
    double wrong = 0;
    for (const std::uint64_t base : {2, 3, 5})
        for (std::uint64_t k = 1; k <= 2000; ++k) {
            const std::uint64_t i = k <= 1000 ? k : 0xFFFFFFFF - k;
            const Rational exact = exact_radical_inverse(base, i);
            const double found = inverse(base, i);
            const auto distance = [&](double x) -> Rational { return abs(Rational(x) - exact); };
            wrong += distance(found) > distance(std::nextafter(found, 0.0)) ||
                     distance(found) > distance(std::nextafter(found, 1.0));
        }
    return wrong;
}

/// sup over t of |share of the numbers below t − t|, for n sorted numbers in [0, 1).
double star_discrepancy(std::vector<double> u) {
    std::ranges::sort(u);
    const auto n = static_cast<double>(u.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const auto below = static_cast<double>(i);
        worst = std::max({worst, (below + 1) / n - u[i], u[i] - below / n});
    }
    return worst;
}
/// n D* of coordinate d over its bound 1 + (b − 1)/(2 ln b) ln n + (b + 1)/2; the worst d.
double discrepancy_over_bound(const Points<3>& points) {
    constexpr double bases[] = {2, 3, 5};
    const auto n = static_cast<double>(points.size());
    double worst = 0.0;
    for (int d = 0; d < 3; ++d) {
        std::vector<double> u;
        for (const Vec<3>& x : points) u.push_back(x[d]);
        const double b = bases[d];
        const double bound = 1 + (b - 1) / (2 * std::log(b)) * std::log(n) + (b + 1) / 2;
        worst = std::max(worst, n * star_discrepancy(u) / bound);
    }
    return worst;
}

/// The largest |share − area| of the boxes [0, x) × [0, y) with corners at coordinates of points,
/// which is the star discrepancy in the plane; the corners on the far faces count, too.
double star_discrepancy(Points<2> points) {
    std::ranges::sort(points, {}, [](const Vec<2>& x) { return x[0]; });
    const auto n = static_cast<double>(points.size());
    std::vector<double> ys;  // of the points left of the corner, sorted
    double worst = 0.0;
    const auto scan = [&](double x) {  // corners at x, closed and open
        for (std::size_t k = 0; k <= ys.size(); ++k) {
            const double y_open = k < ys.size() ? ys[k] : 1.0;
            worst = std::max(worst, std::abs(x * y_open - static_cast<double>(k) / n));
            if (k > 0)
                worst = std::max(worst, std::abs(static_cast<double>(k) / n - x * ys[k - 1]));
        }
    };
    for (const Vec<2>& p : points) {
        scan(p[0]);
        ys.insert(std::ranges::upper_bound(ys, p[1]), p[1]);
        scan(p[0]);
    }
    scan(1.0);
    return worst;
}
double plane_discrepancy_over_bound(const Points<2>& points) {
    const auto n = static_cast<double>(points.size());
    double product = 1.0;
    for (const double b : {2.0, 3.0})
        product *= (b - 1) / (2 * std::log(b)) * std::log(n) + (b + 1) / 2;
    return star_discrepancy(points) * n / (2 + product);
}
/// Both coordinates in base 2: the points lie on the diagonal.
Points<2> with_one_base(Index n) {
    Points<2> points;
    for (Index i = 1; i <= n; ++i) points.push_back(Vec<2>::Constant(radical_inverse(2, i)));
    return points;
}

const Register claims_of_halton{
    Claim{.id = "halton.radical_inverse_is_the_nearest_double",
          .source = {Paper::literature, "Halton 1960"},
          .says = "Φ_b(i) mirrors the digits of i at the point; no other double is nearer",
          .bound = at_most(0, "against exact fractions, 6000 numbers up to 2³² − 1"),
          .measure = [] { return times_not_nearest(radical_inverse); },
          .sabotaged = [] { return times_not_nearest(summed_digit_by_digit); }},
    Claim{.id = "halton.discrepancy_of_each_coordinate",
          .source = {Paper::literature, "Niederreiter 1992, Theorem 3.6"},
          .says = "n D* ≤ 1 + (b − 1)/(2 ln b) ln n + (b + 1)/2 for every coordinate",
          .bound = at_most(1, "the theorem itself, n = 30000; random points have n D* ≈ √n"),
          .measure = [] { return discrepancy_over_bound(halton(unit_box<3>(), 30000)); },
          .sabotaged =
              [] { return discrepancy_over_bound(uniform_random(unit_box<3>(), 30000, 1)); }},
    Claim{.id = "halton.discrepancy_in_the_plane",
          .source = {Paper::literature, "Niederreiter 1992, Theorem 3.6"},
          .says = "n D* ≤ 2 + Π ((b − 1)/(2 ln b) ln n + (b + 1)/2) over all boxes at the origin",
          .bound = at_most(1, "the theorem itself, n = 3000"),
          .measure = [] { return plane_discrepancy_over_bound(halton(unit_box<2>(), 3000)); },
          .sabotaged = [] { return plane_discrepancy_over_bound(with_one_base(3000)); }},
};
}  // namespace
}  // namespace halton_claims
