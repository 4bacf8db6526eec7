#include "solver/approximation/graded_mls_shape.h"

#include "solver/kernels/poly6.h"
#include "solver/particles/graded.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

#include <fmt/format.h>

namespace graded_mls_shape_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

/// Samples whose number density grows 100-fold along x, each with as many others in its support, and a
/// random point among them.
template <int Dim> struct GradedCloud {
    Cloud<Dim> cloud;
    std::vector<double> supports;

    explicit GradedCloud(std::uint64_t seed) {
        constexpr double contrast = 100.0;
        constexpr Index count = Dim == 1 ? 40 : Dim == 2 ? 400 : 3000;
        const double edge = std::pow(count, 1.0 / Dim);
        cloud.x = graded(Box<Dim>{Vec<Dim>::Zero(), Vec<Dim>::Constant(edge)}, count, contrast);
        for (const Vec<Dim>& x : cloud.x) {
            const double density =
                std::pow(contrast, x[0] / edge) * std::log(contrast) / (contrast - 1.0);
            supports.push_back(3.0 * std::pow(density, -1.0 / Dim));
        }
        Random random(seed);
        for (int d = 0; d < Dim; ++d) cloud.at[d] = edge * random.uniform(0.4, 0.7);
        cloud.support = *std::ranges::max_element(supports);
    }
};

/// A slip in the chain rule: derivatives of ω(s r/hⱼ) by its argument.
template <int Order, RadialKernel K> struct UnscaledDerivatives {
    static constexpr int dim = K::dim;
    K w;
    std::span<const double> supports;

    std::optional<Fit> operator()(std::span<const Vec<dim>> x, const Place<dim>& at,
                                  ShapeRow<dim> row) const {
        double largest = 0.0;
        for (std::size_t k = 0; k < at.neighbours.size(); ++k) {
            const Index j = at.neighbours[k];
            const Vec<dim> d = w.support() / supports[j] * (at.x - x[j]);
            row.phi[k] = w.value(d.norm());
            row.grad_phi[k] = gradient(w, d);
            row.laplace_phi[k] = laplacian(w, d.norm());
            largest = std::max(largest, supports[j]);
        }
        return mls_from_weights<dim, Order>(x, at, largest, row);
    }
};

/// The largest error of ⟨q⟩, h ∇⟨q⟩ and h² Δ⟨q⟩ over the monomials q of degree ≤ `degree`, in units of
/// the condition number, over 10 points.
template <int Dim, int Order> double inconsistency(int degree) {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const GradedCloud<Dim> graded(seed);
        const auto& cloud = graded.cloud;
        const double h = cloud.support;
        const auto shape =
            shape_at(GradedMlsShape<Order, Poly6<Dim>>(Poly6<Dim>(1.0), graded.supports), cloud);
        for (const auto& q : monomials<Dim>(degree, cloud.at + Vec<Dim>::Constant(h), h)) {
            const auto f = sampled(cloud, [&](const Vec<Dim>& x) { return q.value(x); });
            const double errors =
                std::max(std::abs(*shape.value(f, 0) - q.value(cloud.at)),
                         h * (*shape.gradient(f, 0) - q.gradient(cloud.at)).norm());
            const double second =
                Order < 2 ? 0.0 : h * h * std::abs(*shape.laplacian(f, 0) - q.laplacian(cloud.at));
            worst = std::max(worst, std::max(errors, second) / shape.fit[0]->condition);
        }
    }
    return worst;
}

/// maxⱼ h |∇Φⱼ − difference quotient of Φⱼ|, over 10 points; `Shape` from (w, supports).
template <int Dim, class Make> double slope_error(Make make) {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const GradedCloud<Dim> graded(seed);
        const Cloud<Dim>& cloud = graded.cloud;
        const auto shape = make(graded.supports);
        const auto near = cloud.near();
        const std::size_t n = near.indices.size();
        const auto row_at = [&](const Vec<Dim>& x) {
            std::vector<double> phi(n), laplace_phi(n);
            std::vector<Vec<Dim>> grad_phi(n);
            shape(cloud.x, Place<Dim>{x, near.of(0)}, ShapeRow<Dim>{phi, grad_phi, laplace_phi});
            return std::pair{phi, grad_phi};
        };
        const auto [phi, grad_phi] = row_at(cloud.at);
        for (int d = 0; d < Dim; ++d) {
            const Vec<Dim> step = 1e-5 * cloud.support * Vec<Dim>::Unit(d);
            const auto ahead = row_at(cloud.at + step).first,
                       behind = row_at(cloud.at - step).first;
            for (std::size_t j = 0; j < n; ++j) {
                const double slope = (ahead[j] - behind[j]) / (2.0 * step[d]);
                worst = std::max(worst, cloud.support * std::abs(grad_phi[j][d] - slope));
            }
        }
    }
    return worst;
}

const Register consistency{in_dimensions<1, 2, 3>([]<int Dim>() {
    return Claim{
        .id = "graded_mls_shape.reproduces_polynomials",
        .source = {Paper::adams2009, "Secs. 3.1, 3.2; Eqs. 25-34"},
        .says =
            "order 2 is exact for quadratic polynomials in value, gradient and Laplacian where "
            "number densities differ 100-fold and supports follow them: error / κ",
        .bound = at_most(1e-11,
                         "N² u κ, N ≤ 10: 1.1e-14 κ; derivatives multiply it by h |∇ω|/ω = 5 and "
                         "h² |Δω|/ω = 22 at a sample's own support, which may be a fifth of the "
                         "largest near by: 5² · 22 · 1.1e-14 = 6e-12"),
        .measure = [] { return inconsistency<Dim, 2>(2); },
        .sabotaged = [] { return inconsistency<Dim, 2>(3); }};
})};

const Register derivatives{in_dimensions<1, 2, 3>([]<int Dim>() {
    return Claim{
        .id = "graded_mls_shape.gradient_is_the_slope",
        .source = {Paper::plumbline, "docstring of GradedMlsShape"},
        .says = "h ∇Φⱼ is the slope of Φⱼ; without the factor s/hⱼ of the chain rule it is not",
        .bound = at_most(1e-5,
                         "steps of 1e-5 h: rounding 1e-16 κ / 1e-5 with κ < 1e4: 1e-7; "
                         "truncation 1e-10 h³ |Φ‴| / 6, h³ |Φ‴| < 1e5"),
        .measure =
            [] {
                return slope_error<Dim>([](const auto& supports) {
                    return GradedMlsShape<1, Poly6<Dim>>(Poly6<Dim>(1.0), supports);
                });
            },
        .sabotaged =
            [] {
                return slope_error<Dim>([](const auto& supports) {
                    return UnscaledDerivatives<1, Poly6<Dim>>{Poly6<Dim>(1.0), supports};
                });
            }};
})};
}  // namespace
}  // namespace graded_mls_shape_claims
