#include "solver/particles/clustered.h"

#include "solver/particles/halton.h"
#include "verification/framework/registry.h"

namespace clustered_claims {
namespace {
using namespace plumbline;
using namespace verification;

const Box<2> box = unit_box<2>();
const Clusters clusters{5, 0.1, 50.0};
constexpr std::uint64_t seed = 4;

double share_in_clusters(const Points<2>& points) {
    const Points<2> centres = cluster_centres(box, clusters.number, seed);
    const auto inside = std::ranges::count_if(points, [&](const Vec<2>& x) {
        return std::ranges::any_of(
            centres, [&](const Vec<2>& c) { return (x - c).norm() < clusters.radius; });
    });
    return static_cast<double>(inside) / static_cast<double>(points.size());
}
/// Number density inside over that outside, over the contrast asked for.
double contrast_ratio(const Points<2>& points) {
    static const double area = share_in_clusters(halton(box, 200000));
    const double share = share_in_clusters(points);
    return share / area / ((1 - share) / (1 - area)) / clusters.contrast;
}
/// A share of contrast/(1 + contrast) in the clusters, whatever their size.
Points<2> with_contrast_of_numbers(Index n) {
    const Points<2> centres = cluster_centres(box, clusters.number, seed);
    Random random(seed);
    Points<2> points;
    while (points.size() < n) {
        const bool wanted = random.uniform() * (1 + clusters.contrast) > 1;
        Vec<2> x;
        do x = random_point(box, random);
        while (wanted != std::ranges::any_of(centres, [&](const Vec<2>& c) {
                   return (x - c).norm() < clusters.radius;
               }));
        points.push_back(x);
    }
    return points;
}

const Register claims_of_clustered{
    Claim{.id = "clustered.contrast",
          .source = {Paper::plumbline, "docstring of clustered"},
          .says = "the number density in the clusters is `contrast` times that outside",
          .bound = between(
              0.87, 1.13,
              "5 standard errors: of an area of at most 5 · 0.0314 the clusters hold 18060 and the "
              "rest 1940 of the points, "
              "√(1/18060 + 1/1940) = 2.4 %; the area, of 200000 Halton points, is known to 1 %"),
          .measure = [] { return contrast_ratio(clustered(box, 20000, clusters, seed)); },
          .sabotaged = [] { return contrast_ratio(with_contrast_of_numbers(20000)); }},
};
}  // namespace
}  // namespace clustered_claims
