#include "solver/approximation/mlsph_shape.h"
#include "solver/foundation/sum.h"
#include "verification/framework/approximation_errors.h"

#include <array>
#include <cmath>

namespace verification {

namespace {
using namespace plumbline;
using enum Quantity;

constexpr std::array approximations{Approximation{value, "MLS 0"},
                                    Approximation{value, "MLS 1"},
                                    Approximation{value, "MLS 2"},
                                    Approximation{value, "MLS 3"},
                                    Approximation{value, "MLSPH"},
                                    Approximation{gradient, "MLS 1"},
                                    Approximation{gradient, "MLS 2"},
                                    Approximation{gradient, "MLS 3"},
                                    Approximation{gradient, "MLSPH"},
                                    Approximation{laplacian, "MLS 2"},
                                    Approximation{laplacian, "MLS 3"},
                                    Approximation{laplacian, "MLSPH"},
                                    Approximation{gradient, "printed Eqs. 29, 30"}};

constexpr double no_answer = std::numeric_limits<double>::quiet_NaN();

/// ⟨f⟩, ∇⟨f⟩ and Δ⟨f⟩ at one point; NaN where the method gives no answer, or where its rank is
/// too small for the derivative to be consistent.
template <int Dim> struct Jet {
    double value = no_answer;
    Vec<Dim> gradient = Vec<Dim>::Constant(no_answer);
    double laplacian = no_answer;
};

template <class Shape>
Jet<Shape::dim> jet(const Shape& shape, const SampledField<Shape::dim>& field, Index i) {
    constexpr int Dim = Shape::dim;
    const Place<Dim> at = field.set.samples().at(i);
    const std::size_t n = at.neighbours.size();
    std::vector<double> phi(n), laplace_phi(n);
    std::vector<Vec<Dim>> grad_phi(n);
    Jet<Dim> jet;
    const auto fit = shape(std::span<const Vec<Dim>>(field.set.x), at,
                           ShapeRow<Dim>{phi, grad_phi, laplace_phi});
    if (!fit) return jet;
    jet = {0.0, Vec<Dim>::Zero(), 0.0};
    for (std::size_t k = 0; k < n; ++k) {
        const double f = field.f[at.neighbours[k]];
        jet.value += phi[k] * f;
        jet.gradient += grad_phi[k] * f;
        jet.laplacian += laplace_phi[k] * f;
    }
    return jet;
}

template <int Dim> void errors(const SampledField<Dim>& field, Index i, std::span<double> error) {
    using K = StudyKernel<Dim>;
    const K& w = field.set.kernel;
    const Jet<Dim> mls_0 = jet(MlsShape<0, K>(w), field, i);
    const Jet<Dim> mls_1 = jet(MlsShape<1, K>(w), field, i);
    const Jet<Dim> mls_2 = jet(MlsShape<2, K>(w), field, i);
    const Jet<Dim> mls_3 = jet(MlsShape<3, K>(w), field, i);
    const Jet<Dim> mlsph = jet(MlsphShape<2, K>(w), field, i);
    const Jet<Dim> diffuse = jet(MlsShape<2, K>(w, MlsDerivative::diffuse), field, i);

    const Vec<Dim>& x = field.set.x[i];
    const double f = TestFunction<Dim>::value(x), laplace_f = TestFunction<Dim>::laplacian(x);
    const Vec<Dim> grad_f = TestFunction<Dim>::gradient(x);
    auto next = error.begin();
    for (const Jet<Dim>* j : {&mls_0, &mls_1, &mls_2, &mls_3, &mlsph})
        *next++ = std::abs(j->value - f);
    for (const Jet<Dim>* j : {&mls_1, &mls_2, &mls_3, &mlsph})
        *next++ = (j->gradient - grad_f).norm();
    for (const Jet<Dim>* j : {&mls_2, &mls_3, &mlsph}) *next++ = std::abs(j->laplacian - laplace_f);
    // Erratum 25: Eq. 30 applied to the centred basis of Eq. 29 as if p(0) did not depend on x. What
    // is lost then is exactly the diffuse derivative, the part in which only p is differentiated.
    *next++ = (mls_2.gradient - diffuse.gradient - grad_f).norm();
}
}  // namespace

template <int Dim> const Family<Dim>& mls_family() {
    static const Family<Dim> family{approximations, errors<Dim>};
    return family;
}
template const Family<2>& mls_family();
template const Family<3>& mls_family();

}  // namespace verification
