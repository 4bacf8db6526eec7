#include "reports/neighbours_plan.h"

#include "solver/neighbours/queries.h"

#include <fmt/format.h>

namespace reports {

namespace {
using namespace benchmarks;
using plumbline::Index;
using plumbline::InvalidInput;

/// The situations once for each value, which set(situation, value) puts in; as they are for no value.
template <class Value, class Set>
std::vector<SearchSituation> times(const std::vector<SearchSituation>& all,
                                   const std::vector<Value>& values, Set set) {
    if (values.empty()) return all;
    std::vector<SearchSituation> product;
    for (const SearchSituation& from : all)
        for (const Value& value : values) {
            SearchSituation s = from;
            set(s, value);
            product.push_back(s);
        }
    return product;
}

void require_in_range(const std::vector<double>& values, double low, double high,
                      const char* option) {
    for (const double v : values)
        if (!(v >= low && v <= high))
            throw InvalidInput(fmt::format("{}: expected a number from {:g} to {:g}, found {:g}",
                                           option, low, high, v));
}

std::string main_axis(const NeighbourRequest& r) {
    if (r.contrasts.size() > 1) return r.own_radii ? "own_radii" : "contrast";
    if (r.counts.size() > 1) return "size";
    if (r.clouds.size() > 1) return "cloud";
    if (r.orders.size() > 1) return "order";
    if (r.spacings.size() > 1) return "radius";
    return r.moved.empty() ? "points" : "moved";
}

/// What the situations of one study have in common.
std::string shared(const SearchSituation& s, const std::string& axis) {
    const bool contrasts = axis == "contrast" || axis == "own_radii";
    return fmt::format("{}|{}|{}|{}|{}|{}", axis == "cloud" ? "" : s.cloud.name,
                       contrasts || axis == "size" ? 0 : s.cloud.count,
                       contrasts ? 0.0 : s.cloud.contrast, axis == "order" ? "" : s.order,
                       axis == "radius" ? 0.0 : s.spacings.value_or(0.0),
                       axis == "moved" ? 0.0 : s.moved.value_or(0.0));
}
}  // namespace

std::vector<SearchStudy> plan(const NeighbourRequest& r) {
    if (r.radius) plumbline::check_radius(plumbline::OpenSpace<3>{}, *r.radius);
    if (r.radius && r.own_radii)
        throw InvalidInput("--radius: expected none beside --own-radii, which sets all radii");
    require_in_range(r.contrasts, 1.0, 1e9, "--contrast");
    require_in_range(r.spacings, 0.1, 100.0, "--spacings");
    require_in_range(r.moved, 0.0, 1.0, "--moved");
    for (const std::string& cloud : r.clouds)
        if (!r.contrasts.empty() && !has_contrast(cloud))
            throw InvalidInput(fmt::format(
                "--contrast: expected a cloud that has one (clustered, graded, two_densities), "
                "found {}",
                cloud));
    SearchSituation usual;
    usual.dim = r.dim;
    usual.radius = r.radius;
    usual.own_radii = r.own_radii;
    if (!r.contrasts.empty()) usual.cloud.name = "graded";
    std::vector<SearchSituation> all{usual};
    all = times(all, r.clouds, [](SearchSituation& s, const std::string& v) { s.cloud.name = v; });
    all = times(all, r.orders, [](SearchSituation& s, const std::string& v) { s.order = v; });
    all = times(all, r.spacings, [](SearchSituation& s, double v) { s.spacings = v; });
    all = times(all, r.moved, [](SearchSituation& s, double v) { s.moved = v; });
    all = times(all, r.counts, [](SearchSituation& s, Index v) { s.cloud.count = v; });
    all = times(all, r.contrasts, [](SearchSituation& s, double v) { s.cloud.contrast = v; });

    const std::string axis = main_axis(r);
    std::vector<SearchStudy> studies;
    std::vector<std::string> keys;
    for (const SearchSituation& s : all) {
        const std::string key = shared(s, axis);
        auto at = static_cast<std::size_t>(std::ranges::find(keys, key) - keys.begin());
        if (at == keys.size()) {
            keys.push_back(key);
            studies.push_back({axis, "Which search is the fastest?", {}});
        }
        studies[at].situations.push_back(s);
    }
    return studies;
}

}  // namespace reports
