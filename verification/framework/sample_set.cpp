#include "verification/framework/sample_set.h"

#include "solver/approximation/density.h"
#include "solver/foundation/random.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/halton.h"
#include "solver/particles/jittered.h"

#include <algorithm>
#include <cmath>

namespace verification {

namespace {
using namespace plumbline;

/// The unit box, widened by whole spacings so that its lattice stays where it is.
template <int Dim> Box<Dim> box_of(const SampleSetup& setup) {
    Box<Dim> box = unit_box<Dim>();
    if (setup.region == Region::boundary) return box;
    const double margin = std::ceil(2.0 * setup.support / setup.spacing) * setup.spacing;
    box.low.array() -= margin;
    box.high.array() += margin;
    return box;
}

template <int Dim> Points<Dim> points_of(const SampleSetup& setup) {
    const Box<Dim> box = box_of<Dim>(setup);
    switch (setup.sampling) {
        case Sampling::lattice:
            return lattice(box, setup.spacing);
        case Sampling::jittered:
            return jittered(box, setup.spacing, study_jitter, setup.seed);
        case Sampling::halton:
            break;
    }
    const auto count = static_cast<Index>(std::lround(box.volume() / std::pow(setup.spacing, Dim)));
    return halton(box, count, static_cast<Index>(1 + 100003 * (setup.seed - 1)));
}

template <int Dim> bool is_measured(const Vec<Dim>& x, const SampleSetup& setup) {
    const Box<Dim> unit = unit_box<Dim>();
    if (setup.region == Region::interior) return unit.contains(x);
    const double to_boundary = std::min((x - unit.low).minCoeff(), (unit.high - x).minCoeff());
    return to_boundary < setup.support;
}

/// `wanted` of them, chosen at random, or all if there are no more; in ascending order.
std::vector<Index> some_of(std::vector<Index> all, std::size_t wanted, std::uint64_t seed) {
    if (all.size() <= wanted) return all;
    Random random(seed);
    for (std::size_t k = 0; k < wanted; ++k)
        std::swap(all[k], all[k + random.bits() % (all.size() - k)]);
    all.resize(wanted);
    std::ranges::sort(all);
    return all;
}
}  // namespace

std::string_view name_of(Sampling sampling) {
    switch (sampling) {
        case Sampling::lattice:
            return "lattice";
        case Sampling::jittered:
            return "jittered";
        case Sampling::halton:
            return "halton";
    }
    return "";
}
std::string_view name_of(Region region) {
    return region == Region::interior ? "interior" : "boundary";
}

template <int Dim>
SamplePoints<Dim>::SamplePoints(const SampleSetup& setup, std::size_t most_measured)
    : x(points_of<Dim>(setup)) {
    for (Index i = 0; i < x.size(); ++i)
        if (is_measured(x[i], setup)) measured.push_back(i);
    measured = some_of(std::move(measured), most_measured, setup.seed);
}

template <int Dim>
SampleSet<Dim>::SampleSet(const SampleSetup& setup)
    : SampleSet(setup, SamplePoints<Dim>(setup, most_measured)) {}

template <int Dim>
SampleSet<Dim>::SampleSet(const SampleSetup& setup, SamplePoints<Dim> points)
    : kernel(setup.support),
      x(std::move(points.x)),
      measured(std::move(points.measured)),
      m(x.size(), std::pow(setup.spacing, Dim)) {
    CellGrid<Dim> search;
    search.build(x, setup.support);
    neighbours = search.query(x);
    V = volumes(kernel, std::span<const Vec<Dim>>(x), std::span<const double>(m), neighbours);
    for (std::size_t i = 0; i < x.size(); ++i) rho.push_back(m[i] / V[i]);
}

template struct SamplePoints<2>;
template struct SamplePoints<3>;
template struct SampleSet<2>;
template struct SampleSet<3>;

}  // namespace verification
