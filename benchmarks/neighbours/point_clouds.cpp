#include "benchmarks/neighbours/point_clouds.h"

#include "benchmarks/neighbours/dam_break.h"
#include "solver/particles/clustered.h"
#include "solver/particles/graded.h"
#include "solver/particles/jittered.h"
#include "solver/particles/uniform_random.h"
#include "verification/framework/statistics.h"

#include <functional>
#include <numbers>

namespace benchmarks {

namespace {
using namespace plumbline;

template <int Dim> double spacing_of(Index count) { return std::pow(count, -1.0 / Dim); }

/// `count` jittered lattice points in a box of the given edge around the centre of the unit box.
template <int Dim> Points<Dim> lattice_of(Index count, double edge, std::uint64_t seed) {
    const Box<Dim> box{Vec<Dim>::Constant(0.5 - 0.5 * edge), Vec<Dim>::Constant(0.5 + 0.5 * edge)};
    const double cells = std::max(1.0, std::round(std::pow(count, 1.0 / Dim)));
    return jittered(box, edge / cells, 0.2, seed);
}

template <int Dim> PointCloud<Dim> two_densities(const CloudRequest& r) {
    const Index half = std::max<Index>(1, r.count / 2);
    const double edge = std::pow(r.contrast, -1.0 / Dim);  // of the dense part
    Points<Dim> points = lattice_of<Dim>(half, 1.0, r.seed);
    const Points<Dim> dense = lattice_of<Dim>(half, edge, r.seed + 1);
    points.insert(points.end(), dense.begin(), dense.end());
    return {"", std::move(points), usual_spacings * edge * spacing_of<Dim>(half)};
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

template <int Dim> Points<Dim> gaussian(Index count, std::uint64_t seed) {
    constexpr Index clusters = 50;
    Random random(seed);
    const Points<Dim> centres = uniform_random(unit_box<Dim>(), clusters, seed + 1);
    std::vector<double> deviations;
    for (Index c = 0; c < clusters; ++c) deviations.push_back(random.uniform(0.005, 0.05));
    Points<Dim> points(count);
    for (Index i = 0; i < count; ++i)
        for (int axis = 0; axis < Dim; ++axis) {  // Box and Muller 1958; 1 - u > 0
            const double far = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
            const double turn = std::cos(2.0 * std::numbers::pi * random.uniform());
            points[i][axis] = centres[i % clusters][axis] + deviations[i % clusters] * far * turn;
        }
    return points;
}

template <int Dim> PointCloud<Dim> with_usual_neighbours(Points<Dim> points) {
    const double radius = radius_with_neighbours(points, usual_neighbours);
    return {"", std::move(points), radius};
}

template <int Dim> struct Maker {
    std::string name;
    std::function<PointCloud<Dim>(const CloudRequest&)> make;
    bool has_contrast = false;
};

template <int Dim> const std::vector<Maker<Dim>>& makers() {
    using Request = const CloudRequest&;
    static const Box<Dim> box = unit_box<Dim>();
    static const std::vector<Maker<Dim>> all{
        {"jittered",
         [](Request r) -> PointCloud<Dim> {
             return {"", lattice_of<Dim>(r.count, 1.0, r.seed),
                     usual_spacings * spacing_of<Dim>(r.count)};
         }},
        {"uniform",
         [](Request r) -> PointCloud<Dim> {
             return {"", uniform_random(box, r.count, r.seed),
                     usual_spacings * spacing_of<Dim>(r.count)};
         }},
        {"clustered",
         [](Request r) {
             return with_usual_neighbours(clustered(box, r.count, {20, 0.05, r.contrast}, r.seed));
         },
         true},
        {"gaussian",
         [](Request r) { return with_usual_neighbours(gaussian<Dim>(r.count, r.seed)); }},
        {"graded",
         [](Request r) { return with_usual_neighbours(graded(box, r.count, r.contrast)); }, true},
        {"two_densities", two_densities<Dim>, true},
        {"planar",
         [](Request r) { return with_usual_neighbours(embedded<Dim, Dim - 1>(r.count, r.seed)); }},
        {"line",
         [](Request r) { return with_usual_neighbours(embedded<Dim, 1>(r.count, r.seed)); }},
        {"dam_break",
         [](Request r) { return with_usual_neighbours(dam_break<Dim>(r.count, r.seed)); }}};
    return all;
}
}  // namespace

std::vector<std::string> cloud_names() {
    std::vector<std::string> names;
    for (const auto& maker : makers<3>()) names.push_back(maker.name);
    return names;
}

bool has_contrast(const std::string& cloud) {
    return std::ranges::any_of(
        makers<3>(), [&](const auto& maker) { return maker.name == cloud && maker.has_contrast; });
}

template <int Dim> PointCloud<Dim> make_cloud(const CloudRequest& request) {
    require_count(request.count);
    if (!(request.contrast >= 1.0 && request.contrast <= 1e9))
        throw InvalidInput("contrast: expected a ratio of densities from 1 to 1e9, found " +
                           std::to_string(request.contrast));
    for (const auto& maker : makers<Dim>()) {
        if (maker.name != request.name) continue;
        PointCloud<Dim> cloud = maker.make(request);
        cloud.name = request.name;
        return cloud;
    }
    std::string expected;
    for (const std::string& known : cloud_names()) expected.append(" ").append(known);
    throw InvalidInput("no cloud \"" + request.name + "\"; expected one of:" + expected);
}

template <int Dim>
double radius_with_neighbours(const Points<Dim>& points, std::size_t neighbours) {
    if (points.size() < 2) return 1.0;
    constexpr std::size_t affordable = 100000000;
    const std::size_t sample =
        std::min(std::clamp<std::size_t>(affordable / points.size(), 21, 101), points.size());
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

template PointCloud<2> make_cloud<2>(const CloudRequest&);
template PointCloud<3> make_cloud<3>(const CloudRequest&);
template double radius_with_neighbours<2>(const Points<2>&, std::size_t);
template double radius_with_neighbours<3>(const Points<3>&, std::size_t);

}  // namespace benchmarks
