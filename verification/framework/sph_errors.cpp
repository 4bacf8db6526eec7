#include "solver/approximation/brookshaw_laplacian.h"
#include "solver/approximation/mueller_gradient.h"
#include "solver/approximation/product_rule_gradient.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "verification/framework/approximation_errors.h"

#include <array>
#include <cmath>

namespace verification {

namespace {
using namespace plumbline;
using enum Quantity;

constexpr std::array approximations{
    Approximation{value, "SPH Eq. 3"},         Approximation{value, "Shepard"},
    Approximation{gradient, "SPH Eq. 9"},      Approximation{gradient, "SPH Eq. 13"},
    Approximation{gradient, "SPH Eq. 17"},     Approximation{gradient, "SPH Eq. 19"},
    Approximation{gradient, "Shepard"},        Approximation{gradient, "Mueller"},
    Approximation{laplacian, "SPH Eq. 11"},    Approximation{laplacian, "SPH Eq. 15"},
    Approximation{laplacian, "Brookshaw"},     Approximation{laplacian, "Shepard"},
    Approximation{laplacian, "printed Eq. 15"}};

constexpr double no_answer = std::numeric_limits<double>::quiet_NaN();

double distance(const std::optional<double>& found, double exact) {
    return found ? std::abs(*found - exact) : no_answer;
}
template <int Dim> double distance(const std::optional<Vec<Dim>>& found, const Vec<Dim>& exact) {
    return found ? (*found - exact).norm() : no_answer;
}

/// Eq. 15 with Δω = ω″ as adams2009 prints it: erratum 17.
template <int Dim>
double printed_laplacian(const StudyKernel<Dim>& w, const Samples<Dim>& s,
                         std::span<const double> f, Index i) {
    return sum<double>(s.neighbours.of(i), [&](Index j) {
        return (f[j] - f[i]) * w.second_derivative((s.x[i] - s.x[j]).norm()) * s.V[j];
    });
}

template <int Dim> void errors(const SampledField<Dim>& field, Index i, std::span<double> error) {
    const SampleSet<Dim>& set = field.set;
    const auto& w = set.kernel;
    const Samples<Dim> s = set.samples();
    const std::span<const double> f = field.f, m = set.m, rho = set.rho;
    const Place<Dim> at = s.at(i);
    const auto f_exact = TestFunction<Dim>::value(set.x[i]);
    const auto grad_f = TestFunction<Dim>::gradient(set.x[i]);
    const auto laplace_f = TestFunction<Dim>::laplacian(set.x[i]);

    auto next = error.begin();
    *next++ = distance(interpolate(w, s, f, at), f_exact);
    *next++ = distance(shepard(w, s, f, at), f_exact);
    *next++ = distance<Dim>(gradient_summation(w, s, f, at), grad_f);
    *next++ = distance<Dim>(gradient_difference(w, s, f, i), grad_f);
    *next++ = distance<Dim>(gradient_mass_weighted(w, s, m, rho, f, i), grad_f);
    *next++ = distance<Dim>(gradient_symmetric(w, s, m, rho, f, i), grad_f);
    *next++ = distance<Dim>(shepard_gradient(w, s, f, at), grad_f);
    *next++ = distance<Dim>(mueller_gradient(w, s, f, i), grad_f);
    *next++ = distance(laplacian_summation(w, s, f, at), laplace_f);
    *next++ = distance(laplacian_difference(w, s, f, i), laplace_f);
    *next++ = distance(laplacian_brookshaw(w, s, f, i), laplace_f);
    *next++ = distance(shepard_laplacian(w, s, f, at), laplace_f);
    *next++ = distance(printed_laplacian(w, s, f, i), laplace_f);
}
}  // namespace

template <int Dim> const Family<Dim>& sph_family() {
    static const Family<Dim> family{approximations, errors<Dim>};
    return family;
}
template const Family<2>& sph_family();
template const Family<3>& sph_family();

}  // namespace verification
