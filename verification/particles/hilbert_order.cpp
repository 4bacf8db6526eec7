#include "solver/particles/hilbert_order.h"

#include "verification/framework/registry.h"

namespace hilbert_order_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// All points of a lattice with 2^k points along each axis, in row order.
template <int Dim> Points<Dim> lattice(int k) {
    const int n = 1 << k;
    Points<Dim> points;
    for (int code = 0; code < static_cast<int>(std::pow(n, Dim)); ++code) {
        Vec<Dim> x;
        for (int d = 0, rest = code; d < Dim; ++d, rest /= n) x[d] = rest % n;
        points.push_back(x);
    }
    return points;
}

/// The longest step of the walk through `points` in `order`, in lattice spacings (1-norm).
template <int Dim> double longest_step(const Points<Dim>& points, const std::vector<Index>& order) {
    double longest = 0.0;
    for (std::size_t k = 1; k < order.size(); ++k)
        longest = std::max(longest, (points[order[k]] - points[order[k - 1]]).template lpNorm<1>());
    return longest;
}

/// How many points `order` leaves out or lists again.
double missing(const std::vector<Index>& order) {
    std::vector<bool> seen(order.size(), false);
    for (const Index i : order) seen[i] = true;
    return static_cast<double>(std::ranges::count(seen, false));
}

template <int Dim> Claim walks_from_face_to_face(int k) {
    const auto longest = [=](auto order_of) {
        const auto points = lattice<Dim>(k);
        return longest_step<Dim>(points, order_of(std::span<const Vec<Dim>>(points)));
    };
    return {.id = "hilbert_order.walks_from_face_to_face_" + std::to_string(Dim) + "d",
            .source = {Paper::literature, "Hilbert 1891; Skilling 2004"},
            .says = "each step of the curve through a lattice goes to a face neighbour",
            .bound = between(1.0, 1.0, "coordinates are small integers: no rounding"),
            .measure = [=] { return longest(hilbert_order<Dim>); },
            .sabotaged = [=] { return longest(morton_order<Dim>); }};
}

double points_lost() {
    const auto points = lattice<3>(4);
    return missing(hilbert_order<3>(points));
}
double points_lost_when_places_stand_for_points() {
    auto order = hilbert_order<3>(lattice<3>(4));
    for (Index& i : order) i /= 2;
    return missing(order);
}

const Register claims_of_hilbert{
    walks_from_face_to_face<2>(5),
    walks_from_face_to_face<3>(4),
    Claim{.id = "hilbert_order.is_a_permutation",
          .source = {Paper::plumbline, "docstring of hilbert_order"},
          .says = "every point is listed once",
          .bound = at_most(0, "a count"),
          .measure = points_lost,
          .sabotaged = points_lost_when_places_stand_for_points},
};
}  // namespace
}  // namespace hilbert_order_claims
