#include "benchmarks/neighbours/point_clouds.h"

#include "solver/particles/clustered.h"
#include "solver/particles/graded.h"
#include "solver/particles/jittered.h"
#include "solver/particles/uniform_random.h"
#include "verification/framework/statistics.h"

#include <functional>

namespace benchmarks {

namespace {
using namespace plumbline;
constexpr std::size_t usual_neighbours = 30;

template <int Dim> double spacing_of(Index count) { return std::pow(count, -1.0 / Dim); }

/// `count` jittered lattice points in a box of the given edge around the centre of the unit box.
template <int Dim> Points<Dim> lattice_of(Index count, double edge, std::uint64_t seed) {
    const Box<Dim> box{Vec<Dim>::Constant(0.5 - 0.5 * edge), Vec<Dim>::Constant(0.5 + 0.5 * edge)};
    const double cells = std::max(1.0, std::round(std::pow(count, 1.0 / Dim)));
    return jittered(box, edge / cells, 0.2, seed);
}

template <int Dim> PointCloud<Dim> two_densities(Index count, std::uint64_t seed) {
    constexpr double edge = 0.1;  // of the dense part
    Points<Dim> points = lattice_of<Dim>(count / 2, 1.0, seed);
    const Points<Dim> dense = lattice_of<Dim>(count - count / 2, edge, seed + 1);
    points.insert(points.end(), dense.begin(), dense.end());
    return {"", std::move(points), 2.0 * edge * spacing_of<Dim>(count / 2)};
}

/// The points of a cloud that fills the first `Filled` axes, at 0.5 along the others.
template <int Dim, int Filled> Points<Dim> embedded(Index count, std::uint64_t seed) {
    Points<Dim> points;
    for (const Vec<Filled>& x : uniform_random(unit_box<Filled>(), count, seed)) {
        Vec<Dim> y = Vec<Dim>::Constant(0.5);
        y.template head<Filled>() = x;
        points.push_back(y);
    }
    return points;
}

template <int Dim> PointCloud<Dim> with_usual_neighbours(Points<Dim> points) {
    const double radius = radius_with_neighbours(points, usual_neighbours);
    return {"", std::move(points), radius};
}

template <int Dim> struct Maker {
    std::string name;
    std::function<PointCloud<Dim>(Index count, std::uint64_t seed)> make;
};

template <int Dim> const std::vector<Maker<Dim>>& makers() {
    static const Box<Dim> box = unit_box<Dim>();
    static const std::vector<Maker<Dim>> all{
        {"jittered",
         [](Index n, std::uint64_t seed) -> PointCloud<Dim> {
             return {"", lattice_of<Dim>(n, 1.0, seed), 2.0 * spacing_of<Dim>(n)};
         }},
        {"uniform",
         [](Index n, std::uint64_t seed) -> PointCloud<Dim> {
             return {"", uniform_random(box, n, seed), 2.0 * spacing_of<Dim>(n)};
         }},
        {"clustered",
         [](Index n, std::uint64_t seed) {
             return with_usual_neighbours(clustered(box, n, {20, 0.05, 100.0}, seed));
         }},
        {"two_densities", [](Index n, std::uint64_t seed) { return two_densities<Dim>(n, seed); }},
        {"graded",
         [](Index n, std::uint64_t) { return with_usual_neighbours(graded(box, n, 1000.0)); }},
        {"planar",
         [](Index n, std::uint64_t seed) {
             return with_usual_neighbours(embedded<Dim, Dim - 1>(n, seed));
         }},
        {"line", [](Index n, std::uint64_t seed) {
             return with_usual_neighbours(embedded<Dim, 1>(n, seed));
         }}};
    return all;
}
}  // namespace

std::vector<std::string> cloud_names() {
    std::vector<std::string> names;
    for (const auto& maker : makers<3>()) names.push_back(maker.name);
    return names;
}

template <int Dim>
PointCloud<Dim> make_cloud(const std::string& name, Index count, std::uint64_t seed) {
    require_count(count);
    for (const auto& maker : makers<Dim>()) {
        if (maker.name != name) continue;
        PointCloud<Dim> cloud = maker.make(count, seed);
        cloud.name = name;
        Random random(seed);
        for (std::size_t i = cloud.points.size(); i > 1; --i)
            std::swap(cloud.points[i - 1], cloud.points[random.bits() % i]);
        return cloud;
    }
    std::string expected;
    for (const std::string& known : cloud_names()) expected.append(" ").append(known);
    throw InvalidInput("no cloud \"" + name + "\"; expected one of:" + expected);
}

template <int Dim>
double radius_with_neighbours(const Points<Dim>& points, std::size_t neighbours) {
    if (points.size() < 2) return 1.0;
    const std::size_t sample = std::min<std::size_t>(101, points.size());
    const std::size_t number = std::min(neighbours, points.size() - 1);
    std::vector<double> radii, distances(points.size());
    for (std::size_t s = 0; s < sample; ++s) {
        const Vec<Dim>& x = points[s * points.size() / sample];
        for (std::size_t j = 0; j < points.size(); ++j) distances[j] = (points[j] - x).norm();
        std::ranges::nth_element(distances,
                                 distances.begin() + static_cast<std::ptrdiff_t>(number));
        radii.push_back(distances[number]);
    }
    const double radius = verification::median(radii);
    return radius > 0.0 ? radius : 1.0;
}

template PointCloud<2> make_cloud<2>(const std::string&, Index, std::uint64_t);
template PointCloud<3> make_cloud<3>(const std::string&, Index, std::uint64_t);
template double radius_with_neighbours<2>(const Points<2>&, std::size_t);
template double radius_with_neighbours<3>(const Points<3>&, std::size_t);

}  // namespace benchmarks
