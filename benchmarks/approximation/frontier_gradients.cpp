#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/mueller_gradient.h"
#include "solver/approximation/product_rule_gradient.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_shape.h"
#include "solver/kernels/all_kernels.h"

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Quantity;

template <RadialKernel K>
std::vector<PreparedMethod> gradients(const K& w, const Situation<K::dim>& s) {
    const auto q = Quantity::gradient;
    std::vector<PreparedMethod> all{
        at_places("SPH Eq. 9", true, s, q, answer_of([&s, w](Index k) {
                      return gradient_summation(w, s.samples(), s.f, place(s, k));
                  })),
        at_places("SPH Eq. 13", true, s, q, answer_of([&s, w](Index k) {
                      return gradient_difference(w, s.samples(), s.f, s.measured[k]);
                  })),
        at_places("SPH Eq. 17", true, s, q, answer_of([&s, w](Index k) {
                      return gradient_mass_weighted(w, s.samples(), s.m, s.rho, s.f, s.measured[k]);
                  })),
        at_places("SPH Eq. 19", true, s, q, answer_of([&s, w](Index k) {
                      return gradient_symmetric(w, s.samples(), s.m, s.rho, s.f, s.measured[k]);
                  })),
        at_places("Mueller", false, s, q, answer_of([&s, w](Index k) {
                      return mueller_gradient(w, s.samples(), s.f, s.measured[k]);
                  }))};
    add_shape_functions<K::dim>(all.front(), {SphShape<K>(w, s.samples())}, s, q);
    add_shape_functions<K::dim>(all.back(), {MuellerShape<K>(w)}, s, q);
    return all;
}
}  // namespace

template <int Dim> std::vector<PreparedMethod> sph_gradients(const Situation<Dim>& s) {
    std::vector<PreparedMethod> all;
    AllKernels::with<Dim>(s.kernel, s.support, [&](const auto& w) { all = gradients(w, s); });
    return all;
}
template std::vector<PreparedMethod> sph_gradients(const Situation<2>&);
template std::vector<PreparedMethod> sph_gradients(const Situation<3>&);

}  // namespace benchmarks
