#include "solver/particles/samplings.h"

#include "verification/framework/registry.h"

namespace samplings_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr Index count = 600, many = 5000;

/// Calls visit(sampling, box) for the samplings of every dimension.
template <class Visit> void for_each_sampling(Visit visit) {
    for (const auto& s : samplings<1>()) visit(s, unit_box<1>());
    for (const auto& s : samplings<2>()) visit(s, unit_box<2>());
    for (const auto& s : samplings<3>()) visit(s, unit_box<3>());
}
bool has_no_seed(std::string_view name) {
    return name == "lattice" || name == "hexagonal" || name == "close_packed" ||
           name == "body_centred" || name == "graded";
}

double not_reproduced(std::uint64_t seed, std::uint64_t again) {
    double different = 0;
    for_each_sampling([&](const auto& s, const auto& box) {
        if (!has_no_seed(s.name))
            different += s.fill(box, count, seed) != s.fill(box, count, again);
    });
    return different;
}
double same_for(std::uint64_t seed, std::uint64_t other) {
    double same = 0;
    for_each_sampling([&](const auto& s, const auto& box) {
        if (!has_no_seed(s.name)) same += s.fill(box, count, seed) == s.fill(box, count, other);
    });
    return same;
}
/// The largest |points / many − 1|.
double worst_count() {
    double worst = 0;
    for_each_sampling([&](const auto& s, const auto& box) {
        const auto n = static_cast<double>(s.fill(box, many, 1).size());
        worst = std::max(worst, std::abs(n / many - 1));
    });
    return worst;
}
/// The spacing as if close packing were cubic.
double worst_count_with_the_cubic_spacing() {
    const auto box = unit_box<3>();
    const auto n = static_cast<double>(close_packed(box, spacing_of(box, many)).size());
    return std::abs(n / many - 1);
}

const Register claims_of_samplings{
    Claim{.id = "samplings.reproducible",
          .source = {Paper::plumbline, "docstring of Sampling"},
          .says = "the same seed gives the same points, bit by bit",
          .bound = at_most(0, "a count of samplings that differ from themselves"),
          .measure = [] { return not_reproduced(7, 7); },
          .sabotaged = [] { return not_reproduced(7, 8); }},
    Claim{.id = "samplings.seeded",
          .source = {Paper::plumbline, "docstring of Sampling"},
          .says = "another seed gives other points",
          .bound = at_most(0, "a count of samplings that do not change"),
          .measure = [] { return same_for(1, 2); },
          .sabotaged = [] { return same_for(1, 1); }},
    Claim{.id = "samplings.count",
          .source = {Paper::plumbline, "docstring of Sampling"},
          .says = "each has about as many points as asked for",
          .bound = at_most(0.167,
                           "5000 points in space are 17.1 spacings along the edge. Close packing: "
                           "15.2 in a row, 17.6 rows, 18.7 layers, of each of which a part may not "
                           "fit: 1 − (14.2/15.2) (16.6/17.6) (17.7/18.7) = 0.166; the other "
                           "lattices lose less. Poisson discs 0.9 spacings apart reach half a "
                           "distance beyond the faces: (1 + 0.9/17.1)³ − 1 = 0.166"),
          .measure = worst_count,
          .sabotaged = worst_count_with_the_cubic_spacing},
};
}  // namespace
}  // namespace samplings_claims
