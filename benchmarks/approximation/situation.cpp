#include "benchmarks/approximation/frontier_methods.h"
#include "solver/approximation/density.h"
#include "solver/kernels/all_kernels.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/halton.h"

#include <cmath>

namespace benchmarks {

using namespace plumbline;

template <int Dim>
Situation<Dim>::Situation(verification::Quantity quantity, std::string kernel_name,
                          double support_in_spacings, int samples_per_metre,
                          std::size_t most_places)
    : kernel(std::move(kernel_name)),
      spacing(1.0 / samples_per_metre),
      support(support_in_spacings / samples_per_metre) {
    using namespace verification;
    SamplePoints<Dim> points({Sampling::jittered, Region::interior, spacing, support, 1},
                             most_places);
    x = std::move(points.x);
    m.assign(x.size(), std::pow(spacing, Dim));
    for (const Vec<Dim>& at : x) f.push_back(TestFunction<Dim>::value(at));
    neighbours = find_neighbours();
    V = sum_volumes();
    for (std::size_t i = 0; i < x.size(); ++i) rho.push_back(m[i] / V[i]);
    if (quantity == Quantity::value) {
        places = halton(unit_box<Dim>(), static_cast<Index>(points.measured.size()));
    } else {
        measured = std::move(points.measured);
        for (const Index i : measured) places.push_back(x[i]);
    }
    CellGrid<Dim> search;
    search.build(x, support);
    rows = search.query(places);
}

template <int Dim> NeighbourLists Situation<Dim>::find_neighbours() const {
    CellGrid<Dim> search;
    search.build(x, support);
    return search.query(x);
}

template <int Dim> std::vector<double> Situation<Dim>::sum_volumes() const {
    std::vector<double> found;
    AllKernels::with<Dim>(kernel, support, [&](const auto& w) {
        found = volumes(w, std::span<const Vec<Dim>>(x), std::span<const double>(m), neighbours);
    });
    return found;
}

template struct Situation<2>;
template struct Situation<3>;

}  // namespace benchmarks
