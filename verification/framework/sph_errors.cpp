#include "solver/approximation/brookshaw_laplacian.h"
#include "solver/approximation/mueller_gradient.h"
#include "solver/approximation/product_rule_gradient.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/foundation/sum.h"
#include "verification/framework/approximation_errors.h"

namespace verification {

namespace {
using namespace plumbline;
using enum Quantity;

/// Eq. 15 with Δω = ω″ as adams2009 prints it: erratum 17.
template <int Dim> double printed_laplacian(const Spot<Dim>& p) {
    return sum<double>(p.at.neighbours, [&](Index j) {
        return (p.f[j] - p.f[p.i]) * p.w.second_derivative((p.at.x - p.s.x[j]).norm()) * p.s.V[j];
    });
}

/// Eq. 37 with tr A / Dim for the matrix A: right where samples lie the same way in all directions.
template <int Dim> Vec<Dim> uncorrected_mueller(const Spot<Dim>& p) {
    double trace = 0.0;
    Vec<Dim> b = Vec<Dim>::Zero();
    for (const Index j : p.at.neighbours) {
        const Vec<Dim> x_ij = p.s.x[j] - p.at.x;
        const double w = p.w.value(x_ij.norm());
        trace += w * x_ij.squaredNorm();
        b += w * (p.f[j] - p.f[p.i]) * x_ij;
    }
    return b * (Dim / trace);
}

template <int Dim> std::vector<Method<Dim>> all_methods() {
    using P = const Spot<Dim>&;
    return {
        {{value, "SPH Eq. 3"}, [](P p) { return p.value_error(interpolate(p.w, p.s, p.f, p.at)); }},
        {{value, "Shepard"}, [](P p) { return p.value_error(shepard(p.w, p.s, p.f, p.at)); }},
        {{gradient, "SPH Eq. 9"},
         [](P p) { return p.gradient_error(gradient_summation(p.w, p.s, p.f, p.at)); }},
        {{gradient, "SPH Eq. 13"},
         [](P p) { return p.gradient_error(gradient_difference(p.w, p.s, p.f, p.i)); }},
        {{gradient, "SPH Eq. 17"},
         [](P p) {
             return p.gradient_error(gradient_mass_weighted(p.w, p.s, p.m, p.rho, p.f, p.i));
         }},
        {{gradient, "SPH Eq. 19"},
         [](P p) { return p.gradient_error(gradient_symmetric(p.w, p.s, p.m, p.rho, p.f, p.i)); }},
        {{gradient, "Shepard"},
         [](P p) { return p.gradient_error(shepard_gradient(p.w, p.s, p.f, p.at)); }},
        {{gradient, "Mueller"},
         [](P p) { return p.gradient_error(mueller_gradient(p.w, p.s, p.f, p.i)); }},
        {{gradient, "Mueller, A a number"},
         [](P p) { return p.gradient_error(uncorrected_mueller(p)); },
         true},
        {{laplacian, "SPH Eq. 11"},
         [](P p) { return p.laplacian_error(laplacian_summation(p.w, p.s, p.f, p.at)); }},
        {{laplacian, "SPH Eq. 15"},
         [](P p) { return p.laplacian_error(laplacian_difference(p.w, p.s, p.f, p.i)); }},
        {{laplacian, "Brookshaw"},
         [](P p) { return p.laplacian_error(laplacian_brookshaw(p.w, p.s, p.f, p.i)); }},
        {{laplacian, "Shepard"},
         [](P p) { return p.laplacian_error(shepard_laplacian(p.w, p.s, p.f, p.at)); }},
        {{laplacian, "printed Eq. 15"},
         [](P p) { return p.laplacian_error(printed_laplacian(p)); },
         true}};
}
}  // namespace

template <int Dim> std::span<const Method<Dim>> sph_methods() {
    static const std::vector<Method<Dim>> all = all_methods<Dim>();
    return all;
}
template std::span<const Method<1>> sph_methods();
template std::span<const Method<2>> sph_methods();
template std::span<const Method<3>> sph_methods();

}  // namespace verification
