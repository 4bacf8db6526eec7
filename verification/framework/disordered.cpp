#include "verification/framework/disordered.h"

#include "solver/approximation/density.h"
#include "solver/foundation/random.h"

namespace verification {

namespace {
PatchShape with_support(PatchShape shape, double support) {
    shape.support = support;
    return shape;
}
}  // namespace

template <int Dim>
Disordered<Dim>::Disordered(double support, PatchShape shape)
    : w(support), patch(cubic_lattice<Dim>(1.0), with_support(shape, support)) {
    plumbline::Random random(shape.seed + 1);
    for (std::size_t i = 0; i < patch.x.size(); ++i) m.push_back(random.uniform(0.5, 1.5));
    const std::span<const plumbline::Vec<Dim>> x(patch.x);
    const auto s = patch.samples();
    rho = plumbline::at_all(
        m.size(), [&](plumbline::Index i) { return plumbline::density(w, x, m, s.at(i)); });
    patch.V = plumbline::volumes(w, x, m, patch.neighbours);
}

template struct Disordered<1>;
template struct Disordered<2>;
template struct Disordered<3>;

}  // namespace verification
