#include "verification/framework/sample_set.h"

#include "solver/approximation/density.h"
#include "solver/foundation/random.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/quintic_spline.h"
#include "solver/kernels/wendland_c4.h"
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

/// How many places the error is measured at, per seed; a lattice has one seed only.
template <int Dim> std::size_t places_in(Sampling sampling) {
    const std::size_t places = Dim == 3 ? 200 : 400;
    return sampling == Sampling::lattice ? 5 * places : places;
}

/// Places take numbers of the Halton sequence that Halton samples do not: they would lie alike.
constexpr Index first_place = 2000003;

/// Halton points in the unit box, or in its rim of one support less the outermost half spacing, where
/// no sample is further out.
template <int Dim> Points<Dim> places_between(const SampleSetup& setup) {
    const auto first = static_cast<Index>(first_place + 100003 * (setup.seed - 1));
    const auto count = static_cast<double>(places_in<Dim>(setup.sampling));
    Box<Dim> box = unit_box<Dim>();
    if (setup.region == Region::interior) return halton(box, static_cast<Index>(count), first);
    box.low.array() += 0.5 * setup.spacing;
    box.high.array() -= 0.5 * setup.spacing;
    const double inside = std::max(0.0, 1.0 - 2.0 * setup.support);
    const double share = 1.0 - std::pow(inside, Dim) / box.volume();
    Points<Dim> places = halton(box, static_cast<Index>(std::ceil(count / share)), first);
    std::erase_if(places, [&](const Vec<Dim>& x) { return !is_measured(x, setup); });
    return places;
}

template <class T> std::vector<T> chosen(const std::vector<T>& all, std::span<const Index> which) {
    std::vector<T> some;
    for (const Index i : which) some.push_back(all[i]);
    return some;
}

/// The samples that any place feels, in ascending order.
std::vector<Index> felt_at(NeighbourLists rows) {
    std::vector<Index>& felt = rows.indices;
    std::ranges::sort(felt);
    felt.erase(std::unique(felt.begin(), felt.end()), felt.end());
    return std::move(felt);
}

/// At `places`, whose neighbours are among `x`, by Eq. 5.
template <int Dim>
std::vector<double> densities(const AnyKernel<Dim>& w, const Points<Dim>& x, double mass,
                              const Points<Dim>& places, const NeighbourLists& rows) {
    const std::vector<double> m(x.size(), mass);
    return at_all(places.size(), [&](Index k) {
        return density(w, std::span<const Vec<Dim>>(x), std::span<const double>(m),
                       Place<Dim>{places[k], rows.of(k)});
    });
}

/// Row k as row which[k] of n, the others empty; `which` is in ascending order.
NeighbourLists spread(const NeighbourLists& rows, std::span<const Index> which, std::size_t n) {
    NeighbourLists all{{0}, rows.indices};
    for (std::size_t i = 0, k = 0; i < n; ++i) {
        if (k < which.size() && which[k] == i) ++k;
        all.offsets.push_back(rows.offsets[k]);
    }
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

std::string_view name_of(StudyKernel kernel) {
    switch (kernel) {
        case StudyKernel::poly6:
            return "poly6";
        case StudyKernel::wendland_c4:
            return "wendland_c4";
        case StudyKernel::quintic_spline:
            break;
    }
    return "quintic_spline";
}

template <int Dim>
SamplePoints<Dim>::SamplePoints(const SampleSetup& setup, std::size_t most_measured)
    : x(points_of<Dim>(setup)) {
    for (Index i = 0; i < x.size(); ++i)
        if (is_measured(x[i], setup)) measured.push_back(i);
    measured = some_of(std::move(measured), most_measured, setup.seed);
}

template <int Dim> AnyKernel<Dim> kernel_of(StudyKernel kernel, double support) {
    switch (kernel) {
        case StudyKernel::poly6:
            return AnyKernel<Dim>(Poly6<Dim>(support));
        case StudyKernel::wendland_c4:
            return AnyKernel<Dim>(WendlandC4<Dim>(support));
        case StudyKernel::quintic_spline:
            break;
    }
    return AnyKernel<Dim>(QuinticSpline<Dim>(support));
}

template <int Dim>
SampleSet<Dim>::SampleSet(const SampleSetup& setup)
    : kernel(kernel_of<Dim>(setup.kernel, setup.support)) {
    SamplePoints<Dim> all(setup, places_in<Dim>(setup.sampling));
    places = setup.measured_at == MeasuredAt::between ? places_between<Dim>(setup)
                                                      : chosen(all.x, all.measured);
    CellGrid<Dim> search;
    search.build(all.x, setup.support);
    const std::vector<Index> felt = felt_at(search.query(places));
    x = chosen(all.x, felt);
    m.assign(x.size(), std::pow(setup.spacing, Dim));
    rho = densities(kernel, all.x, m.front(), x, search.query(x));
    for (std::size_t i = 0; i < x.size(); ++i) V.push_back(m[i] / rho[i]);

    search.build(x, setup.support);
    rows = search.query(places);
    if (setup.measured_at == MeasuredAt::samples) {
        for (const Index i : all.measured)
            measured.push_back(
                static_cast<Index>(std::ranges::lower_bound(felt, i) - felt.begin()));
        neighbours = spread(rows, measured, x.size());
    }
}

#define PLUMBLINE_INSTANTIATE(Dim)     \
    template struct SamplePoints<Dim>; \
    template struct SampleSet<Dim>;    \
    template AnyKernel<Dim> kernel_of<Dim>(StudyKernel, double);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace verification
