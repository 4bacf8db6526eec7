#include "solver/kernels/anisotropic.h"

#include "solver/kernels/poly6.h"
#include "solver/kernels/wendland_c4.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"
#include "verification/kernels/radial.h"

namespace anisotropic_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double h = 0.7;
const Mat<2> G{{1.5, 0.4}, {-0.2, 0.6}};  // singular values 1.553 and 0.631

/// ∫ g(x) dV in the plane over the ellipse {x : ‖G x‖ < h}: in polar coordinates, the angle by the
/// trapezoidal rule, which converges exponentially for periodic functions.
template <class F> double integrate_over_ellipse(F f) {
    constexpr int n = 128;
    double total = 0.0;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        const Vec<2> n_k(std::cos(angle), std::sin(angle));
        const double rim = h / (G * n_k).norm();
        total += integrate([&](double r) { return f(Vec<2>(r * n_k)) * r; }, 0.0, rim);
    }
    return total * 2 * std::numbers::pi / n;
}

const Poly6<2> radial(h);
const Anisotropic<Poly6<2>> w(radial, G);

double integral_error(double determinant) {
    return std::abs(determinant * integrate_over_ellipse([](const Vec<2>& x) {
                        return radial.value((G * x).norm());
                    }) -
                    1.0);
}

/// ∇ω against central differences of ω, and ∇∇ω against those of ∇ω, relative, at any x and G.
template <class Gradient> double gradient_error(Gradient gradient) {
    return worst_error([gradient] {
        const Mat<3> g =
            Mat<3>::Identity() + 0.3 * Mat<3>{point<3>(-1, 1) * (point<3>(-1, 1)).transpose()};
        const Anisotropic<WendlandC4<3>> kernel(WendlandC4<3>{h}, g);
        const Vec<3> x = point<3>(-0.3, 0.3);
        Vec<3> slope;
        for (int d = 0; d < 3; ++d) {
            const Vec<3> e = 1e-5 * h * Vec<3>::Unit(d);
            slope[d] = (kernel.value(x + e) - kernel.value(x - e)) / (2e-5 * h);
        }
        return (gradient(kernel, g, x) - slope).norm() * std::pow(h, 4);
    });
}
template <class Laplacian> double laplacian_error(Laplacian laplacian) {
    return worst_error([laplacian] {
        const Mat<3> g =
            Mat<3>::Identity() + 0.3 * Mat<3>{point<3>(-1, 1) * (point<3>(-1, 1)).transpose()};
        const Anisotropic<WendlandC4<3>> kernel(WendlandC4<3>{h}, g);
        const Vec<3> x = point<3>(-0.3, 0.3);
        double divergence = 0.0;
        for (int d = 0; d < 3; ++d) {
            const Vec<3> e = 1e-5 * h * Vec<3>::Unit(d);
            divergence += (kernel.gradient(x + e)[d] - kernel.gradient(x - e)[d]) / (2e-5 * h);
        }
        return (laplacian(kernel, g, x) - divergence) * std::pow(h, 5);
    });
}

const Source source{Paper::adams2009, "Sec. 2.1"};
const Register claims_of_anisotropic{
    Claim{.id = "anisotropic.integrates_to_one",
          .source = source,
          .says =
              "|det G| ω₀(‖G x‖) integrates to 1, as Sec. 2.1 asks of kernels that are not radial",
          .bound = at_most(1e-12, "quadrature 1e-13; trapezoidal rule: 2 (0.922 / 2.184)^64"),
          .measure = [] { return integral_error(w.value(Vec<2>::Zero()) / radial.value(0.0)); },
          .sabotaged = [] { return integral_error(1.0); }},
    Claim{.id = "anisotropic.zero_outside_its_ball",
          .source = {Paper::plumbline, "docstring of Anisotropic"},
          .says = "ω = 0 for ‖x‖ ≥ support(), in all of 1000 directions; the largest value",
          .bound = at_most(0, "‖G x‖ ≥ σ_min ‖x‖; a margin of 1e-12 covers the rounding of σ_min"),
          .measure =
              [] {
                  return worst_error(
                      [] {
                          const double angle = uniform(0.0, 7.0), r = w.support() * (1 + 1e-12);
                          return w.value(r * Vec<2>(std::cos(angle), std::sin(angle)));
                      },
                      {.number = 1000});
              },
          .sabotaged =
              [] {  // the support of the radial kernel taken for that of the ellipsoid
                  return worst_error(
                      [] {
                          const double angle = uniform(0.0, 7.0);
                          return w.value(h * Vec<2>(std::cos(angle), std::sin(angle)));
                      },
                      {.number = 1000});
              }},
    Claim{.id = "anisotropic.gradient",
          .source = source,
          .says = "∇ω = |det G| Gᵀ (∇ω₀)(G x); error in units of h⁻⁴",
          .bound =
              at_most(1e-6, "central differences, step 1e-5 h: 1e-10 |ω‴| h⁶ / 6, |ω‴| < 1e4 h⁻⁶"),
          .measure =
              [] {
                  return gradient_error([](const auto& kernel, const Mat<3>&, const Vec<3>& x) {
                      return kernel.gradient(x);
                  });
              },
          .sabotaged =
              [] {  // Gᵀ forgotten
                  return gradient_error([](const auto& kernel, const Mat<3>& g, const Vec<3>& x) {
                      return Vec<3>(g.transpose().inverse() * kernel.gradient(x));
                  });
              }},
    Claim{.id = "anisotropic.laplacian",
          .source = source,
          .says = "Δω = |det G| tr(Gᵀ ∇∇ω₀(G x) G) = ∇ · ∇ω; error in units of h⁻⁵",
          .bound = at_most(
              1e-5, "central differences, step 1e-5 h: 1e-10 · 3 |ω⁗| h⁷ / 6, |ω⁗| < 1e5 h⁻⁷"),
          .measure =
              [] {
                  return laplacian_error([](const auto& kernel, const Mat<3>&, const Vec<3>& x) {
                      return kernel.laplacian(x);
                  });
              },
          .sabotaged =
              [] {  // the radial kernel's Laplacian at G x, without the map's two factors
                  return laplacian_error([](const auto&, const Mat<3>& g, const Vec<3>& x) {
                      return g.determinant() * laplacian(WendlandC4<3>{h}, (g * x).norm());
                  });
              }},
};
}  // namespace
}  // namespace anisotropic_claims
