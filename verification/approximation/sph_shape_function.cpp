#include "solver/approximation/sph_shape_function.h"

#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/registry.h"

namespace sph_shape_function_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// max over samples of |Σⱼ Φⱼ fⱼ − ⟨f⟩|, and of its derivatives in units of h; `volume_of(i, j)` is whose
/// volume is taken: Vⱼ in Eq. 40.
template <int Dim, class VolumeOf> double distance_from_sums(VolumeOf volume_of) {
    const auto& d = disordered<Dim>();
    const auto s = d.samples();
    const double h = d.w.support();
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const auto at = s.at(i);
        double value = 0.0, laplacian_sum = 0.0;
        Vec<Dim> slope = Vec<Dim>::Zero();
        for (const Index j : at.neighbours) {
            const double f = d.f[j] * s.V[volume_of(i, j)] / s.V[j];
            value += sph_shape_function(d.w, s, j, at.x) * f;
            slope += sph_shape_gradient(d.w, s, j, at.x) * f;
            laplacian_sum += sph_shape_laplacian(d.w, s, j, at.x) * f;
        }
        worst = std::max({worst, std::abs(value - interpolate(d.w, s, d.f, at)),
                          (slope - gradient_summation(d.w, s, d.f, at)).norm() * h,
                          std::abs(laplacian_sum - laplacian_summation(d.w, s, d.f, at)) * h * h});
    }
    return worst;
}

const Register claims_of_shape_functions{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_shape_function.sums_are_the_interpolation",
        .source = {Paper::adams2009, "Eqs. 39, 40"},
        .says =
            "Σ Φⱼ fⱼ, Σ ∇Φⱼ fⱼ, Σ ΔΦⱼ fⱼ are Eqs. 3, 9, 11, with Φⱼ = Vⱼ ω: the volume of the "
            "sample, not of the place",
        .bound = at_most(4e-12, "100 terms, Σ |terms| < 320 / h²: 320 · 110 · 1.1e-16"),
        .measure = [] { return distance_from_sums<D>([](Index, Index j) { return j; }); },
        .sabotaged = [] { return distance_from_sums<D>([](Index i, Index) { return i; }); }};
})};
}  // namespace
}  // namespace sph_shape_function_claims
