#include "benchmarks/neighbours/agreement.h"

#include "solver/neighbours/brute_force.h"
#include "verification/neighbours/searches.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace benchmarks {

namespace {
using namespace plumbline;

template <int Dim> double radius_of(const PointCloud<Dim>& cloud, std::size_t i) {
    return cloud.radii.empty() ? cloud.radius : cloud.radii[i];
}
}  // namespace

double memory_bytes() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double free_memory_bytes() {
    std::ifstream info("/proc/meminfo");
    for (std::string word; info >> word;)
        if (double kilobytes = 0.0; word == "MemAvailable:" && info >> kilobytes)
            return 1024.0 * kilobytes;
    return memory_bytes();
}

template <int Dim> double affordable_lists(const PointCloud<Dim>& cloud) {
    if (cloud.points.empty()) throw InvalidInput("comparison: expected points, found none");
    check_radius(OpenSpace<Dim>{}, cloud.radius);
    check_points(OpenSpace<Dim>{}, std::span<const Vec<Dim>>(cloud.points));
    const std::size_t n = cloud.points.size(), sample = affordable_rows(n, 1e8);
    const std::size_t rows = std::min<std::size_t>(sample, 100);
    double neighbours = 0.0;
    for (std::size_t s = 0; s < rows; ++s) {
        const std::size_t i = s * n / rows;
        const double r = radius_of(cloud, i);
        for (const Vec<Dim>& x : cloud.points)
            if (squared_distance(OpenSpace<Dim>{}, cloud.points[i], x) < r * r) neighbours += 1.0;
    }
    const double lists =
        neighbours / static_cast<double>(rows) * static_cast<double>(n) * sizeof(Index);
    const double memory = memory_bytes();
    constexpr double copies = 4.0;  // two searches, each with what it fills its lists from
    if (copies * lists > memory)
        throw InvalidInput(
            fmt::format("comparison: a radius of {:.17g} makes lists of {:.3g} GB, expected at "
                        "most a quarter of the memory, {:.3g} GB",
                        cloud.radius, lists * 1e-9, memory / copies * 1e-9));
    return lists;
}

std::size_t affordable_rows(std::size_t points, double pairs) {
    const auto n = static_cast<double>(points);
    return static_cast<std::size_t>(std::clamp(std::floor(pairs / std::max(n, 1.0)), 1.0, n));
}

template <class Real, int Dim>
std::size_t wrong_against_brute_force(const PointCloud<Dim>& cloud, const NeighbourLists& lists,
                                      std::size_t rows) {
    if (lists.size() != cloud.points.size()) return std::max<std::size_t>(1, cloud.points.size());
    std::vector<VecOf<Real, Dim>> points, queries;
    for (const Vec<Dim>& x : cloud.points) points.push_back(x.template cast<Real>());
    std::vector<double> radii;
    NeighbourLists found{{0}, {}};
    for (std::size_t k = 0; k < rows; ++k) {
        const auto i = static_cast<Index>(k * points.size() / rows);
        queries.push_back(points[i]);
        radii.push_back(radius_of(cloud, i));
        found.indices.insert(found.indices.end(), lists.of(i).begin(), lists.of(i).end());
        found.offsets.push_back(found.indices.size());
    }
    BruteForce<Dim, OpenSpace<Dim>, Real> oracle;
    oracle.build(points, cloud.radius);
    return verification::wrong_pairs(found, oracle.query(queries, radii));
}

template double affordable_lists<2>(const PointCloud<2>&);
template double affordable_lists<3>(const PointCloud<3>&);
template std::size_t wrong_against_brute_force<double, 2>(const PointCloud<2>&,
                                                          const NeighbourLists&, std::size_t);
template std::size_t wrong_against_brute_force<double, 3>(const PointCloud<3>&,
                                                          const NeighbourLists&, std::size_t);
template std::size_t wrong_against_brute_force<float, 2>(const PointCloud<2>&,
                                                         const NeighbourLists&, std::size_t);
template std::size_t wrong_against_brute_force<float, 3>(const PointCloud<3>&,
                                                         const NeighbourLists&, std::size_t);

}  // namespace benchmarks
