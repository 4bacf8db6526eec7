#include "benchmarks/neighbours/agreement.h"
#include "benchmarks/neighbours/growth.h"
#include "benchmarks/neighbours/local_radii.h"
#include "benchmarks/neighbours/particle_order.h"
#include "benchmarks/neighbours/verdicts.h"
#include "reports/neighbours_tables.h"
#include "solver/neighbours/brute_force.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

namespace neighbours_test {
namespace {
using namespace benchmarks;
using plumbline::Index;
using plumbline::InvalidInput;

/// Ten rounds of one total time each, with so much scatter.
SearchResult search(std::string name, double seconds, double scatter = 0.0) {
    SearchResult s{.name = std::move(name)};
    for (int round = 0; round < 10; ++round) {
        const double factor = 1.0 + scatter * (round % 2 == 0 ? 1.0 : -1.0);
        s.runs.build.push_back(0.25 * seconds * factor);
        s.runs.query.push_back(0.75 * seconds * factor);
    }
    return s;
}

CaseResult result_of(std::vector<SearchResult> searches, Index count = 1000) {
    CaseResult result;
    result.cloud = "jittered";
    result.order = "shuffled";
    result.dim = 3;
    result.threads = 1;
    result.count = count;
    result.mean_neighbours = 30;
    result.searches = std::move(searches);
    return result;
}

/// A study of one cloud whose kd_tree and hash_grid take times given by functions of the count.
template <class Tree, class Grid> SearchStudyResult over_size(Tree tree, Grid grid) {
    SearchStudyResult study{"size", "", {}};
    for (const Index n : {1000u, 10000u, 100000u, 1000000u})
        study.cases.push_back(
            result_of({search("kd_tree", tree(n)), search("hash_grid", grid(n))}, n));
    return study;
}

SearchStudyResult over_contrast(std::vector<double> grid_over_tree) {
    SearchStudyResult study{"contrast", "", {}};
    double contrast = 1.0;
    for (const double ratio : grid_over_tree) {
        study.cases.push_back(result_of({search("kd_tree", 1.0), search("hash_grid", ratio)}));
        study.cases.back().contrast = contrast;
        contrast *= 10.0;
    }
    return study;
}
}  // namespace

TEST_CASE("the interval of a ratio is that of the sign test, and has no end below six rounds") {
    // P(Bin(9, 1/2) < 2) = 10 / 512: the second smallest and largest of nine hold the median.
    const std::vector<double> ones(9, 1.0), nine{9, 1, 8, 2, 7, 3, 6, 4, 5};
    const Ratio r = ratio_of(nine, ones);
    CHECK(r.value == 5.0);
    CHECK(r.low == 2.0);
    CHECK(r.high == 8.0);
    const Ratio six = ratio_of(std::vector<double>{1, 2, 3, 4, 5, 6}, ones);
    CHECK(six.low == 1.0);
    CHECK(six.high == 6.0);
    CHECK(std::isinf(ratio_of(std::vector<double>{1, 2, 3, 4, 5}, ones).high));
    const Ratio noisy = ratio_of(std::vector<double>(9, 2.0), ones, 0.25);
    CHECK(noisy.low == Approx(1.6));
    CHECK(noisy.high == Approx(2.5));
}

TEST_CASE("a ranking is given only where the intervals are apart") {
    const CaseResult apart =
        result_of({search("slow", 3.0), search("fast", 1.0), search("middle", 2.0)});
    CHECK(places_of(apart) == std::vector<Places>{{3, 3}, {1, 1}, {2, 2}});
    CHECK(recommendation(apart).starts_with("fast, 2x (± 1 %) faster than middle"));

    // The median of a/b is 1, but half of the ratios are above, half below.
    SearchResult twin = search("twin", 1.0, 0.2);
    const CaseResult tied = result_of({search("fast", 1.0), twin, search("slow", 3.0)});
    CHECK(places_of(tied) == std::vector<Places>{{1, 2}, {1, 2}, {3, 3}});
    CHECK(recommendation(tied).find("which is faster cannot be told") != std::string::npos);
    CHECK(recommendation(tied).find("faster than slow") != std::string::npos);

    CaseResult noisy = result_of({search("fast", 1.0), search("next", 1.1)});
    noisy.noise = 0.2;
    CHECK(standing_of(noisy).best.size() == 2);
}

TEST_CASE("a search that disagrees has no place, no speed, and is named") {
    SearchResult wrong = search("wrong", 0.1);
    wrong.wrong_pairs = 7;
    const CaseResult result = result_of({search("right", 1.0), wrong});
    CHECK_FALSE(result.all_agree());
    const auto places = places_of(result);
    CHECK(places[0] == Places{1, 1});
    CHECK(places[1] == Places{});
    CHECK(reports::table_of(result).find("DISAGREES: 7 wrong pairs; not timed") !=
          std::string::npos);
    for (SearchResult s : {search("a", 1.0), search("b", 1.0)}) {
        s.wrong_pairs = 1;
        CHECK(recommendation(result_of({s})) == "no search agrees with brute force");
    }
}

TEST_CASE("one pair missing, or one too many, is found against brute force") {
    const auto cloud = make_cloud<3>({.name = "uniform", .count = 500});
    plumbline::BruteForce<3> oracle;
    oracle.build(cloud.points, cloud.radius);
    const plumbline::NeighbourLists right = oracle.query(cloud.points);
    CHECK(wrong_against_brute_force(cloud, right, 500) == 0);
    plumbline::NeighbourLists less = right;
    less.indices.pop_back();
    --less.offsets.back();
    CHECK(wrong_against_brute_force(cloud, less, 500) == 1);
    plumbline::NeighbourLists other = right;
    other.indices[0] = other.indices[0] == 499 ? 498 : 499;
    CHECK(wrong_against_brute_force(cloud, other, 500) > 0);
    CHECK(wrong_against_brute_force(cloud, {}, 500) > 0);
}

TEST_CASE("exponents are those of the times, and n log n is told from n") {
    const auto study = over_size([](double n) { return 1e-9 * n * std::log(n); },
                                 [](double n) { return 1e-8 * n; });
    const auto build = exponents(study.cases, [](const Runs& runs) { return runs.build; });
    REQUIRE(build.size() == 2);
    CHECK(build[0].value == Approx(build[0].n_log_n).margin(0.01));
    CHECK(build[0].n_log_n == Approx(1.0 + std::log(2.0) / std::log(1000.0)));
    CHECK(build[1].value == Approx(1.0));
    CHECK(verdicts_on_section_5_3(study)[0].word == "holds");
    const auto reversed = over_size([](double n) { return 1e-8 * n; },
                                    [](double n) { return 1e-9 * n * std::log(n); });
    CHECK(verdicts_on_section_5_3(reversed)[0].word == "does not hold");
}

TEST_CASE("growth is judged apart for each kind of memory, and only where laws can be told apart") {
    auto study = over_size([](double n) { return 1e-9 * n * std::log(n); },
                           [](double n) { return 1e-8 * n; });
    for (CaseResult& c : study.cases)
        for (SearchResult& s : c.searches)
            s.held_bytes = c.count < 100000 ? 0 : std::size_t{1} << 40;
    CHECK(growth(study.cases, "hash_grid", Phase::build).empty());  // two sizes here, two there
    CHECK(verdicts_on_section_5_3(study)[0].word == "cannot be told");
    const auto fits = [](double low, double high) {
        return GrowthIn{"", 10, 100, {"", 0.5 * (low + high), low, high, 1.1}};
    };
    CHECK(follows({fits(0.98, 1.02)}, Law::linear) == Told::yes);
    CHECK(follows({fits(0.98, 1.02), fits(0.9, 1.3)}, Law::linear) == Told::yes);
    CHECK(follows({fits(0.9, 1.3)}, Law::linear) == Told::unknown);
    CHECK(follows({fits(0.98, 1.02), fits(1.2, 1.3)}, Law::linear) == Told::unknown);
    CHECK(follows({fits(1.2, 1.3), fits(1.2, 1.3)}, Law::linear) == Told::no);
    CHECK(follows({}, Law::linear) == Told::unknown);
}

TEST_CASE("sorting is judged by its share of a step") {
    const auto word_for = [](double share, double scatter) {
        CaseResult c = result_of({search("cell_grid_packed", 1.0)});
        c.moved = 0.1;
        for (int round = 0; round < 10; ++round) {
            const double update = share + scatter * (round % 2 == 0 ? 1.0 : -1.0);
            c.searches[0].runs.update.push_back(update);
            c.searches[0].runs.requery.push_back(1.0 - update);
        }
        return verdicts_on_section_5_3({"moved", "", {c}}).at(0).word;
    };
    CHECK(word_for(0.1, 0.01) == "does not hold");
    CHECK(word_for(0.8, 0.01) == "holds");
    CHECK(word_for(0.5, 0.1) == "cannot be told");
}

TEST_CASE("the crossover is the contrast from which on the kd-tree is surely faster") {
    const auto crossed = over_contrast({0.5, 2.0, 0.9, 1.5, 3.0});
    CHECK(verdicts_on_section_5_3(crossed)[0].word == "holds");
    CHECK(crossover_in_words(crossed.cases) ==
          "One radius for all: beside the hash grid, the kd-tree is surely slower up to 1:1, "
          "faster from "
          "1:1000 on");
    const auto never = over_contrast({0.5, 0.6, 0.7});
    CHECK(verdicts_on_section_5_3(never)[0].word == "does not hold");
    CHECK(crossover_in_words(never.cases).ends_with("the kd-tree is slower even at 1:100"));
    auto noisy = over_contrast({0.5, 0.6, 1.1});
    for (CaseResult& c : noisy.cases) c.noise = 0.2;
    CHECK(verdicts_on_section_5_3(noisy)[0].word == "cannot be told");
}

TEMPLATE_TEST_CASE_SIG("every cloud has about as many points as asked, and their usual radius", "",
                       ((int Dim), Dim), 2, 3) {
    for (const std::string& name : cloud_names()) {
        INFO(name);
        const auto cloud = make_cloud<Dim>({.name = name, .count = 2000});
        CHECK(std::abs(static_cast<double>(cloud.points.size()) / 2000.0 - 1.0) < 0.15);
        plumbline::BruteForce<Dim> search;
        search.build(cloud.points, cloud.radius);
        const auto lists = search.query(cloud.points);
        const double mean =
            static_cast<double>(lists.indices.size()) / static_cast<double>(lists.size());
        CHECK(mean > 5.0);
        CHECK(mean < 100.0);
        CHECK(make_cloud<Dim>({.name = name, .count = 2000}).points == cloud.points);
    }
    CHECK_THROWS_AS(make_cloud<Dim>({.name = "cube"}), InvalidInput);
    CHECK_THROWS_AS(make_cloud<Dim>({.count = 0}), InvalidInput);
    CHECK_THROWS_AS(make_cloud<Dim>({.name = "graded", .contrast = 0.5}), InvalidInput);
}

TEST_CASE("two densities have the contrast that was asked") {
    const auto cloud = make_cloud<3>({.name = "two_densities", .count = 16000, .contrast = 1000});
    const auto inside = std::ranges::count_if(
        cloud.points, [](const auto& x) { return (x.array() - 0.5).abs().maxCoeff() < 0.05; });
    // Half of the points and a thousandth of the other half, which is on a lattice of 20^3.
    CHECK(inside == Approx(8000 + 8).margin(10));
}

TEST_CASE("the dam break has water below Ritter's surface, one layer of wall, and nothing else") {
    const auto points = make_cloud<2>({.name = "dam_break", .count = 4000}).points;
    const double c = std::sqrt(9.81), time = 0.3;
    std::size_t water = 0;
    for (const auto& x : points) {
        const bool is_wall = x[0] < 0.0 || x[0] > 5.366 || x[1] < 0.0;
        if (is_wall) continue;
        ++water;
        const double s = std::clamp(2.0 * c - (x[0] - 2.0) / time, 0.0, 3.0 * c);
        CHECK(x[1] <= s * s / (9.0 * 9.81));
    }
    // Volume is conserved: 2 m² of water at one point per spacing², 5.4 + 2 · 2 m of wall.
    const double spacing = std::sqrt(2.0 / static_cast<double>(water));
    CHECK(static_cast<double>(points.size() - water) == Approx(9.4 / spacing).epsilon(0.05));
}

TEST_CASE("an order moves the points and their radii together") {
    for (const std::string& order : order_names()) {
        auto cloud = make_cloud<3>({.name = "uniform", .count = 300});
        for (const auto& x : cloud.points) cloud.radii.push_back(x[0]);
        const auto before = cloud.points;
        reorder(cloud, order);
        CHECK((cloud.points == before) == (order == "as_given"));
        std::set<double> remaining;
        for (std::size_t i = 0; i < before.size(); ++i) {
            CHECK(cloud.radii[i] == cloud.points[i][0]);
            remaining.insert(cloud.points[i][1]);
        }
        CHECK(remaining.size() == before.size());
    }
    auto cloud = make_cloud<3>({.count = 8});
    CHECK_THROWS_AS(reorder(cloud, "sideways"), InvalidInput);
}

TEST_CASE("radii of their own give every point as many neighbours") {
    auto cloud = make_cloud<3>({.name = "graded", .count = 1000});
    cloud.radii = local_radii(cloud.points, 30);
    plumbline::BruteForce<3> search;
    search.build(cloud.points, 1.0);
    const auto lists = search.query(cloud.points, cloud.radii);
    // Itself and those closer than the thirtieth; its distance may be rounded to either side.
    for (Index i = 0; i < lists.size(); ++i)
        CHECK((lists.of(i).size() == 30 || lists.of(i).size() == 31));
    const plumbline::Points<3> same(50, plumbline::Vec<3>::Zero());
    CHECK(local_radii(same, 30) == std::vector<double>(50, 1.0));
}

TEST_CASE("a comparison refuses what makes no sense or does not fit into memory") {
    ComparisonOptions how;
    how.searches = {"cell_grid"};
    PointCloud<3> cloud{"none", {}, 1.0};
    CHECK_THROWS_AS(compare(cloud, how), InvalidInput);
    cloud = make_cloud<3>({.count = 1000});
    cloud.radius = -1.0;
    CHECK_THROWS_AS(compare(cloud, how), InvalidInput);
    cloud = make_cloud<3>({.count = 200000});
    cloud.radius = 10.0;  // 4e10 neighbours
    CHECK_THROWS_AS(compare(cloud, how), InvalidInput);
    how.searches = {"telepathy"};
    CHECK_THROWS_AS(compare(make_cloud<3>({.count = 8}), how), InvalidInput);
}

TEST_CASE("one point, and points that coincide, can be compared, and an update is measured") {
    ComparisonOptions how;
    how.least = how.most = 2;
    how.moved = 0.5;
    const PointCloud<2> one{"one", {plumbline::Vec<2>(1.0, 2.0)}, 1.0};
    const CaseResult lonely = compare(one, how);
    CHECK(lonely.all_agree());
    CHECK(lonely.mean_neighbours == 1.0);
    const PointCloud<3> same{"same", plumbline::Points<3>(40, plumbline::Vec<3>::Zero()), 1.0};
    const CaseResult result = compare(same, how);
    CHECK(result.all_agree());
    CHECK(result.mean_neighbours == 40.0);
    for (const SearchResult& s : result.searches) CHECK(s.runs.step().size() == 2);
}

}  // namespace neighbours_test
