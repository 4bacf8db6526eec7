#include "solver/fluid/number_density.h"

#include "solver/particles/lattice.h"
#include "verification/fluid/force_claims.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace number_density_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double h = 2.6, heavy = 1000.0;

/// A lattice of two fluids, the densities 1000 and 1, below and above the plane through the origin.
template <int Dim> Drop<Dim> two_layers() {
    Drop<Dim> layers;
    const auto around = Vec<Dim>::Constant(Dim == 2 ? 6.0 : 4.0);
    const auto points = lattice<Dim>({-around, around}, 1.0);
    layers.x.assign(points.begin(), points.end());
    layers.v.assign(points.size(), Vec<Dim>::Zero());
    layers.m.clear();
    for (const Vec<Dim>& x : points) layers.m.push_back(x[Dim - 1] < 0.0 ? heavy : 1.0);
    return layers;
}
/// max |ρ/m over its mean − 1|, that is of ρ/ρ₀, over particles farther than h from the edges.
template <int Dim, class Pass> double error_of_density(Pass density) {
    const Drop<Dim> layers = two_layers<Dim>();
    const auto scene = evaluated<Dim>(layers, density);
    const double inside = (Dim == 2 ? 6.0 : 4.0) - h;
    double least = HUGE_VAL, most = 0.0;
    for (std::size_t i = 0; i < layers.x.size(); ++i) {
        if (layers.x[i].cwiseAbs().maxCoeff() > inside) continue;
        const double ratio = scene.template get<Density>()[i] / layers.m[i];
        least = std::min(least, ratio), most = std::max(most, ratio);
    }
    return most / least - 1.0;
}

const Register jump{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "number_density.jumps",
                 .source = {Paper::literature, "Solenthaler and Pajarola 2008"},
                 .says =
                     "densities on both sides of the surface between fluids of 1000 and 1, over "
                     "those far from it: largest relative difference; by Eq. 5 the light one is "
                     "taken for hundreds of times too dense",
                 .bound = at_most(1e-14, "the same 20 to 80 terms in another order"),
                 .measure = [] { return error_of_density<D>(NumberDensity<W<D>>{W<D>(h)}); },
                 .sabotaged = [] { return error_of_density<D>(SphDensity<W<D>>{W<D>(h)}); }};
})};
}  // namespace
}  // namespace number_density_claims
