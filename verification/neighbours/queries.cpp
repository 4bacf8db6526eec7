#include "solver/neighbours/queries.h"

#include "solver/foundation/random.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/printed_hash_grid.h"
#include "verification/neighbours/searches.h"

#include <rapidcheck.h>

namespace queries_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Up to some hundred points on multiples of 1/8, so that sums and squares are exact, and points
/// coincide, lie on faces of cells and at exactly the radius more often than not.
Points<3> any_points() {
    const auto coordinate = rc::gen::inRange(-12, 13);
    const auto all = *rc::gen::container<std::vector<std::array<int, 3>>>(
        rc::gen::container<std::array<int, 3>>(coordinate));
    Points<3> points;
    for (const auto& k : all) points.push_back(0.125 * Vec<3>(k[0], k[1], k[2]));
    return points;
}
double any_radius() { return 0.125 * *rc::gen::inRange(1, 16); }

template <class Search> NeighbourLists lists_of(Search& search, const Points<3>& x, double radius) {
    search.build(x, radius);
    return search.query(x);
}

/// The lists after all points were renamed: j becomes place[j].
NeighbourLists renamed(const NeighbourLists& lists, const std::vector<Index>& place) {
    std::vector<std::vector<Index>> rows(lists.size());
    for (Index i = 0; i < lists.size(); ++i) {
        for (const Index j : lists.of(i)) rows[place[i]].push_back(place[j]);
        std::ranges::sort(rows[place[i]]);
    }
    NeighbourLists all{{0}, {}};
    for (const auto& row : rows) {
        all.indices.insert(all.indices.end(), row.begin(), row.end());
        all.offsets.push_back(all.indices.size());
    }
    return all;
}

// Each is a property of one search, whatever its lists are compared with.
const auto unchanged_by_order = [](auto search) {
    const Points<3> x = any_points();
    const double radius = any_radius();
    std::vector<Index> place(x.size());
    std::iota(place.begin(), place.end(), Index{0});
    plumbline::Random random(*rc::gen::arbitrary<std::uint64_t>());
    for (std::size_t i = place.size(); i > 1; --i)
        std::swap(place[i - 1], place[random.bits() % i]);
    Points<3> shuffled(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) shuffled[place[i]] = x[i];
    RC_ASSERT(lists_of(search, shuffled, radius) == renamed(lists_of(search, x, radius), place));
};
const auto unchanged_by_translation = [](auto search) {
    Points<3> x = any_points();
    const double radius = any_radius();
    const auto before = lists_of(search, x, radius);
    const Vec<3> shift(0.125 * *rc::gen::inRange(-99, 99), 0.125 * *rc::gen::inRange(-99, 99),
                       0.125);
    for (Vec<3>& p : x) p += shift;
    RC_ASSERT(lists_of(search, x, radius) == before);
};
const auto unchanged_by_rotation = [](auto search) {
    Points<3> x = any_points();
    const double radius = any_radius();
    const auto before = lists_of(search, x, radius);
    for (Vec<3>& p : x) p = Vec<3>(-p[1], p[2], -p[0]);
    RC_ASSERT(lists_of(search, x, radius) == before);
};
const auto unchanged_by_scaling = [](auto search) {
    Points<3> x = any_points();
    const double radius = any_radius(), scale = std::ldexp(1.0, *rc::gen::inRange(-60, 60));
    const auto before = lists_of(search, x, radius);
    for (Vec<3>& p : x) p *= scale;
    RC_ASSERT(lists_of(search, x, radius * scale) == before);
};
const auto mutual_and_own = [](auto search) {
    const Points<3> x = any_points();
    const auto lists = lists_of(search, x, any_radius());
    for (Index i = 0; i < lists.size(); ++i) {
        RC_ASSERT(std::ranges::binary_search(lists.of(i), i));
        for (const Index j : lists.of(i)) RC_ASSERT(std::ranges::binary_search(lists.of(j), i));
    }
};
const auto as_brute_force = [](auto search) {
    const Points<3> x = any_points();
    const double radius = any_radius();
    BruteForce<3> oracle;
    RC_ASSERT(lists_of(search, x, radius) == lists_of(oracle, x, radius));
};

/// Lists that end after so many neighbours, the first ones as stored; a tolerance in metres.
struct FlawedSearch {
    Index most_neighbours = std::numeric_limits<Index>::max();
    double tolerance = 0.0;
    BruteForce<3> search{};

    void build(const Points<3>& x, double radius) { search.build(x, radius + tolerance); }
    NeighbourLists query(const Points<3>& x) const {
        const NeighbourLists all = search.query(x);
        NeighbourLists kept{{0}, {}};
        for (Index i = 0; i < all.size(); ++i) {
            for (const Index j : all.of(i))
                if (kept.indices.size() - kept.offsets.back() < most_neighbours)
                    kept.indices.push_back(j);
            kept.offsets.push_back(kept.indices.size());
        }
        return kept;
    }
};

template <class Property> double counterexamples_in_all_searches(Property property) {
    double found = 0.0;
    for_each_search<3>(
        [&](auto search) { found += counterexamples([&] { property(search); }, {.number = 60}); });
    return found;
}
template <class Property> double counterexamples_in_printed_algorithm(Property property) {
    return counterexamples([&] { property(PrintedHashGrid<3>(1.0)); });
}

template <class Property>
Claim claim_of(const std::string& id, const std::string& says, Property property) {
    return {
        .id = "neighbour_search." + id,
        .source = {Paper::adams2009, "Sec. 5"},
        .says = says,
        .bound = at_most(0.0, "coordinates are small multiples of a power of two: all is exact"),
        .measure = [property] { return counterexamples_in_all_searches(property); },
        .sabotaged = [property] { return counterexamples_in_printed_algorithm(property); }};
}

std::vector<Claim> claims_of_symmetries() {
    std::vector<Claim> claims{
        claim_of("unchanged_by_translation", "moving all points changes no list",
                 unchanged_by_translation),
        claim_of("unchanged_by_rotation", "a rotation by 120° with a mirror image changes no list",
                 unchanged_by_rotation),
        claim_of("mutual_and_own", "i lists itself, and j iff j lists i", mutual_and_own),
        claim_of("as_brute_force", "random clouds with ties and coincident points, as brute force",
                 as_brute_force),
        claim_of("unchanged_by_order", "renaming the points renames them in the lists",
                 unchanged_by_order),
        claim_of("unchanged_by_scaling", "another unit of length changes no list",
                 unchanged_by_scaling)};
    // Algorithm 4 keeps these two: its cells scale with the radius, and do not see the order.
    claims[4].sabotaged = [] {
        return counterexamples([] { unchanged_by_order(FlawedSearch{.most_neighbours = 3}); });
    };
    claims[5].sabotaged = [] {
        return counterexamples([] { unchanged_by_scaling(FlawedSearch{.tolerance = 1e-3}); });
    };
    return claims;
}

const Register claims_of_queries{claims_of_symmetries()};
}  // namespace
}  // namespace queries_claims
