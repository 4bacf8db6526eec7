#include "solver/approximation/sph_shape.h"

#include "solver/approximation/shape_functions.h"
#include "solver/approximation/sph_divergence.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/foundation/random.h"
#include "solver/kernels/poly6.h"
#include "solver/neighbours/brute_force.h"
#include "verification/framework/patch.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace sph_shape_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

/// A disordered patch in space, with volumes that differ, and its shape functions of SPH.
struct Setting {
    Poly6<3> w{2.5};
    Patch<3> patch{1.0, 2.5, 0.3};
    std::vector<double> f;
    std::vector<Vec<3>> v;

    Setting() {
        Random random(5);
        for (double& V : patch.V) V *= random.uniform(0.5, 1.5);
        for (std::size_t j = 0; j < patch.x.size(); ++j) {
            f.push_back(random.uniform(-1.0, 1.0));
            v.push_back({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), f[j]});
        }
    }
    /// At a point off the samples; `volumes` stands in for the volumes.
    auto shape(const std::vector<double>& volumes) const {
        const Samples<3> samples{patch.x, volumes, patch.neighbours};
        return precompute<SphShape<Poly6<3>>>(SphShape<Poly6<3>>(w, samples), patch.x, at, lists(),
                                              Derivatives::laplacian);
    }
    auto shape() const { return shape(patch.V); }
    auto shape_without_volumes() const { return shape(std::vector<double>(patch.V.size(), 1.0)); }
    NeighbourLists lists() const {
        BruteForce<3> search;
        search.build(patch.x, w.support());
        return search.query(at);
    }
    std::array<Vec<3>, 1> at{Vec<3>{0.3, -0.2, 0.1}};
};

template <class Form> double difference(bool volumes, Form form) {
    const Setting s;
    const auto lists = s.lists();
    const Place<3> place{s.at[0], lists.of(0)};
    return form(s, volumes ? s.shape() : s.shape_without_volumes(), place);
}
double of_value(bool volumes) {
    return difference(volumes, [](const Setting& s, const auto& shape, const Place<3>& at) {
        return std::abs(*shape.value(s.f, 0) - interpolate(s.w, s.patch.samples(), s.f, at));
    });
}
double of_gradient(bool volumes) {
    return difference(volumes, [](const Setting& s, const auto& shape, const Place<3>& at) {
        return (*shape.gradient(s.f, 0) - gradient_summation(s.w, s.patch.samples(), s.f, at))
            .norm();
    });
}
double of_divergence(bool volumes) {
    return difference(volumes, [](const Setting& s, const auto& shape, const Place<3>& at) {
        return std::abs(*shape.divergence(s.v, 0) -
                        divergence_summation(s.w, s.patch.samples(), s.v, at));
    });
}
double of_laplacian(bool volumes) {
    return difference(volumes, [](const Setting& s, const auto& shape, const Place<3>& at) {
        return std::abs(*shape.laplacian(s.f, 0) -
                        laplacian_summation(s.w, s.patch.samples(), s.f, at));
    });
}

Claim claim(const char* id, const char* source, const char* says, double (*measure)(bool)) {
    return {.id = id,
            .source = {Paper::adams2009, source},
            .says = says,
            .bound = at_most(1e-13,
                             "65 terms below 1, the factors of each multiplied in another "
                             "order: 65 · 3 u = 2e-14"),
            .measure = [=] { return measure(true); },
            .sabotaged = [=] { return measure(false); }};
}
const Register claims{
    claim("sph_shape.value_is_eq_3", "Eqs. 3, 39, 40; Table 1",
          "Σ Φⱼ fⱼ with Φⱼ = Vⱼ ω is the SPH interpolation of Eq. 3", of_value),
    claim("sph_shape.gradient_is_eq_9", "Eqs. 9, 39, 40; Table 1",
          "Σ ∇Φⱼ fⱼ with Φⱼ = Vⱼ ω is the SPH gradient of Eq. 9", of_gradient),
    claim("sph_shape.divergence_is_eq_12", "Eqs. 12, 33, 40; Table 1",
          "Σ ∇Φⱼ · fⱼ with Φⱼ = Vⱼ ω is the SPH divergence of Eq. 12", of_divergence),
    claim("sph_shape.laplacian_is_eq_11", "Eqs. 11, 39, 40; Table 1",
          "Σ ΔΦⱼ fⱼ with Φⱼ = Vⱼ ω is the SPH Laplacian of Eq. 11 with the true Δω", of_laplacian),
};
}  // namespace
}  // namespace sph_shape_claims
