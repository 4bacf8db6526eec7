#include "benchmarks/neighbours/comparison.h"

#include <catch2/catch.hpp>

namespace contestants_test {
namespace {
using namespace benchmarks;

template <int Dim> CaseResult compare_all(const std::string& cloud, bool own_radii) {
    ComparisonOptions how;
    how.least = how.most = 1;
    how.own_radii = own_radii;
    how.moved = 0.3;
    how.brute_force_pairs = 1e7;
    return compare(make_cloud<Dim>({.name = cloud, .count = 1500}), how);
}
}  // namespace

TEMPLATE_TEST_CASE_SIG("every contestant agrees, in every form of its answer, also after updates",
                       "", ((int Dim), Dim), 2, 3) {
    for (const char* cloud : {"uniform", "graded", "line", "dam_break"})
        for (const bool own_radii : {false, true}) {
            const CaseResult result = compare_all<Dim>(cloud, own_radii);
            for (const SearchResult& s : result.searches) {
                INFO(cloud << " " << s.name << (own_radii ? " with own radii" : ""));
                CHECK(s.wrong_pairs == 0);
                CHECK(s.runs.update.size() == 1);
            }
            const bool all = result.searches.size() == contestant_names().size();
            CHECK(all != own_radii);  // some have one radius only
        }
}

TEST_CASE("a contestant is made by its name, and only by that") {
    const auto names = contestant_names();
    for (const char* known : {"cell_grid", "kd_tree", "nanoflann", "cgal_kd_tree"})
        CHECK(std::ranges::find(names, known) != names.end());
    for (const std::string& name : names) CHECK(make_contestant<2>(name) != nullptr);
    CHECK_THROWS_AS(make_contestant<3>("telepathy"), plumbline::InvalidInput);
}

}  // namespace contestants_test
