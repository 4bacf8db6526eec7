#include "solver/fluid/density_diffusion.h"

#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace density_diffusion_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> auto diffused() {
    return evaluated<Dim>(Drop<Dim>{}, DensityDiffusion<WendlandC2<Dim>>{
                                           WendlandC2<Dim>(Drop<Dim>::support), 0.1, 10.0});
}
/// |Σ weight dρ/dt| / Σ |weight dρ/dt| with the weight m/ρ, or m.
template <int Dim> double total(bool by_volume) {
    const auto scene = diffused<Dim>();
    const auto& m = scene.template get<Masses>();
    const auto& rho = scene.template get<Density>();
    const auto& rate = scene.template get<Rate<Density>>();
    double sum = 0.0, size = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const double change = rate[i] * m[i] / (by_volume ? rho[i] : 1.0);
        sum += change, size += std::abs(change);
    }
    return std::abs(sum) / size;
}
/// The largest dρ/dt · sign over particles that have the greatest (sign 1) or least (−1) density among
/// their neighbours.
template <int Dim> double growth_of_extrema(double sign) {
    const auto scene = diffused<Dim>();
    const auto& rho = scene.template get<Density>();
    const auto& lists = scene.template get<Neighbourhood<Dim>>().lists;
    double largest = -HUGE_VAL;
    for (Index i = 0; i < rho.size(); ++i) {
        const auto js = lists.of(i);
        if (std::ranges::all_of(js, [&](Index j) { return rho[j] <= rho[i]; }))
            largest = std::max(largest, sign * scene.template get<Rate<Density>>()[i]);
    }
    return largest;
}

const Register conserved{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "density_diffusion.conserves",
                 .source = {Paper::literature, "Molteni and Colagrossi 2009"},
                 .says = "|Σ (m/ρ) dρ/dt| / Σ |…| = 0: what one particle gains, others lose",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return total<D>(true); },
                 .sabotaged = [] { return total<D>(false); }};
})};
const Register extrema{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "density_diffusion.lowers_maxima",
                 .source = {Paper::literature, "Molteni and Colagrossi 2009"},
                 .says = "dρ/dt < 0 where ρ is the greatest among its neighbours",
                 .bound = at_most(0.0, "every term has ρⱼ − ρᵢ ≤ 0 and −ω′/r ≥ 0"),
                 .measure = [] { return growth_of_extrema<D>(1.0); },
                 .sabotaged = [] { return growth_of_extrema<D>(-1.0); }};
})};
}  // namespace
}  // namespace density_diffusion_claims
