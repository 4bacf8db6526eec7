#include "benchmarks/approximation/frontier_methods.h"
#include "solver/approximation/density.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/halton.h"

#include <cmath>

namespace benchmarks {

using namespace plumbline;

Situation::Situation(verification::Quantity quantity, std::string kernel_name,
                     double support_in_spacings, int samples_per_metre, std::size_t most_places)
    : kernel(std::move(kernel_name)),
      spacing(1.0 / samples_per_metre),
      support(support_in_spacings / samples_per_metre) {
    using namespace verification;
    SamplePoints<2> points({Sampling::jittered, Region::interior, spacing, support, 1},
                           most_places);
    x = std::move(points.x);
    m.assign(x.size(), spacing * spacing);
    for (const Vec<2>& at : x) f.push_back(Franke::value(at));
    CellGrid<2> search;
    search.build(x, support);
    neighbours = search.query(x);
    FrontierKernels::with<2>(kernel, support, [&](const auto& w) {
        V = volumes(w, std::span<const Vec<2>>(x), std::span<const double>(m), neighbours);
    });
    for (std::size_t i = 0; i < x.size(); ++i) rho.push_back(m[i] / V[i]);
    if (quantity == Quantity::value) {
        places = halton(unit_box<2>(), static_cast<Index>(points.measured.size()));
    } else {
        measured = std::move(points.measured);
        for (const Index i : measured) places.push_back(x[i]);
    }
    rows = search.query(places);
}

int components_of(verification::Quantity quantity) {
    return quantity == verification::Quantity::gradient ? 2 : 1;
}

}  // namespace benchmarks
