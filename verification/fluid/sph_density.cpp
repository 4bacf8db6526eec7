#include "solver/fluid/sph_density.h"

#include "solver/approximation/density.h"
#include "solver/kernels/poly6.h"
#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace sph_density_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// max |ρ − density()| / ρ over the drop.
template <int Dim, class K> double difference_from_formula(const K& w) {
    const Drop<Dim> drop;
    const auto scene = evaluated<Dim>(drop);
    const auto& lists = scene.template get<Neighbourhood<Dim>>().lists;
    const auto& rho = scene.template get<Density>();
    double worst = 0.0;
    for (Index i = 0; i < rho.size(); ++i) {
        const double expected = density<K>(w, drop.x, drop.m, Place<Dim>{drop.x[i], lists.of(i)});
        worst = std::max(worst, std::abs(rho[i] - expected) / expected);
    }
    return worst;
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    const double h = Drop<D>::support;
    return Claim{
        .id = "sph_density.is_eq_5",
        .source = {Paper::adams2009, "Eq. 5; Alg. 5"},
        .says = "the pass gives the density that approximation/density.h has at each particle",
        .bound = at_most(2e-14,
                         "the same terms, each to 4 roundings, in the same order: "
                         "70 · 1.1e-16, twice"),
        .measure = [h] { return difference_from_formula<D>(WendlandC2<D>(h)); },
        .sabotaged = [h] { return difference_from_formula<D>(Poly6<D>(h)); }};
})};
}  // namespace
}  // namespace sph_density_claims
