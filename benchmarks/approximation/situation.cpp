#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/framework/timing.h"
#include "solver/approximation/density.h"
#include "solver/kernels/all_kernels.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/packed_lists.h"
#include "solver/particles/halton.h"

#include <cmath>
#include <numeric>

namespace benchmarks {

using namespace plumbline;

namespace {
/// The densities at `places`, whose neighbours are `rows`.
template <int Dim, class Lists>
std::vector<double> densities(const Situation<Dim>& s, std::span<const Vec<Dim>> places,
                              const Lists& rows) {
    std::vector<double> found;
    AllKernels::with<Dim>(s.kernel, s.support, [&](const auto& w) {
        found = at_all(places.size(), [&](Index k) {
            return density(w, std::span<const Vec<Dim>>(s.x), std::span<const double>(s.m),
                           Place<Dim>{places[k], rows.of(k)});
        });
    });
    return found;
}

/// In turns of so many samples that their lists stay small: those of all would have thousands of
/// neighbours each where supports are wide.
template <int Dim> void sum_densities(Situation<Dim>& s, const CellGrid<Dim>& search) {
    constexpr std::size_t at_once = 4096;
    Box<Dim> near = unit_box<Dim>();
    near.low.array() -= s.support;
    near.high.array() += s.support;
    std::vector<Index> felt;
    for (Index i = 0; i < s.x.size(); ++i)
        if (near.contains(s.x[i])) felt.push_back(i);
    s.rho.assign(s.x.size(), std::numeric_limits<double>::quiet_NaN());
    PackedLists rows;
    for (std::size_t first = 0; first < felt.size(); first += at_once) {
        Points<Dim> at;
        for (std::size_t k = first; k < std::min(first + at_once, felt.size()); ++k)
            at.push_back(s.x[felt[k]]);
        search.query(at, rows);
        const auto found = densities(s, std::span<const Vec<Dim>>(at), rows);
        for (std::size_t k = 0; k < found.size(); ++k)
            if (std::isfinite(found[k])) s.rho[felt[first + k]] = found[k];
    }
}

/// The rows of some samples, which ascend, as those of `size` samples, the others empty.
NeighbourLists spread(const NeighbourLists& rows, std::span<const Index> samples,
                      std::size_t size) {
    NeighbourLists all{std::vector<std::size_t>(size + 1, 0), rows.indices};
    for (Index k = 0; k < samples.size(); ++k) all.offsets[samples[k] + 1] = rows.of(k).size();
    std::partial_sum(all.offsets.begin(), all.offsets.end(), all.offsets.begin());
    return all;
}

/// About `most` of the samples: those in a box around the centre.
template <int Dim> Points<Dim> central(const Situation<Dim>& s, std::size_t most) {
    const double half = 0.5 * s.spacing * std::pow(static_cast<double>(most), 1.0 / Dim);
    Points<Dim> found;
    for (const Vec<Dim>& x : s.x)
        if ((x.array() - 0.5).abs().maxCoeff() < half) found.push_back(x);
    return found;
}

double median_seconds(int rounds, const std::function<void()>& work) {
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) seconds.push_back(seconds_of(work));
    return summarise(seconds).median_s;
}
}  // namespace

template <int Dim>
Situation<Dim>::Situation(verification::Quantity quantity, std::string kernel_name,
                          double h_over_spacing, int samples_per_metre, std::size_t most_places)
    : kernel(std::move(kernel_name)),
      support_in_spacings(h_over_spacing),
      spacing(1.0 / samples_per_metre),
      support(support_in_spacings / samples_per_metre) {
    using namespace verification;
    SamplePoints<Dim> points({Sampling::jittered, Region::interior, spacing, support, 1},
                             most_places);
    x = std::move(points.x);
    m.assign(x.size(), std::pow(spacing, Dim));
    for (const Vec<Dim>& at : x) f.push_back(TestFunction<Dim>::value(at));
    CellGrid<Dim> search;
    search.build(x, support);
    sum_densities(*this, search);
    for (std::size_t i = 0; i < x.size(); ++i) V.push_back(m[i] / rho[i]);
    if (quantity == Quantity::value) {
        places = halton(unit_box<Dim>(), static_cast<Index>(points.measured.size()));
    } else {
        measured = std::move(points.measured);
        for (const Index i : measured) places.push_back(x[i]);
    }
    rows = search.query(places);
    neighbours =
        measured.empty() ? spread({{0}, {}}, {}, x.size()) : spread(rows, measured, x.size());
}

template <int Dim> SampleCosts Situation<Dim>::sample_costs(int rounds) const {
    constexpr double most_pairs = 1e6;
    const double pairs_each =
        static_cast<double>(rows.indices.size()) / static_cast<double>(rows.size());
    const Points<Dim> some = central(*this, static_cast<std::size_t>(most_pairs / pairs_each));
    CellGrid<Dim> search;
    NeighbourLists lists;
    const double build = median_seconds(rounds, [&] { search.build(x, support); });
    const double query = median_seconds(rounds, [&] { search.query(some, lists); });
    const double sums =
        median_seconds(rounds, [&] { densities(*this, std::span<const Vec<Dim>>(some), lists); });
    const auto n = static_cast<double>(some.size());
    return {build / static_cast<double>(x.size()) + query / n, sums / n};
}

template struct Situation<2>;
template struct Situation<3>;

}  // namespace benchmarks
