#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/brookshaw_laplacian.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/approximation/sph_shape.h"
#include "solver/kernels/all_kernels.h"

#include <cmath>

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Quantity;

template <RadialKernel K>
std::vector<PreparedMethod> values(const K& w, const Situation<K::dim>& s) {
    const auto q = Quantity::value;
    // Equal volumes where there is no density: masses are equal, and Shepard's quotient takes any factor.
    const bool has_density = w.value(0.0) < HUGE_VAL;
    const Samples<K::dim> weighted{s.x, has_density ? s.V : s.m, s.neighbours};
    std::vector<PreparedMethod> all{
        at_places("SPH Eq. 3", true, s, q, answer_of([&s, w](Index k) {
                      return interpolate(w, s.samples(), s.f, place(s, k));
                  })),
        at_places("Shepard", has_density, s, q, answer_of([&s, w, weighted](Index k) {
                      return shepard(w, weighted, s.f, place(s, k));
                  }))};
    add_shape_functions<K::dim>(all.front(), {SphShape<K>(w, s.samples())}, s, q);
    return all;
}

template <RadialKernel K>
std::vector<PreparedMethod> laplacians(const K& w, const Situation<K::dim>& s) {
    const auto q = Quantity::laplacian;
    std::vector<PreparedMethod> all{
        at_places("SPH Eq. 11", true, s, q, answer_of([&s, w](Index k) {
                      return laplacian_summation(w, s.samples(), s.f, place(s, k));
                  })),
        at_places("SPH Eq. 15", true, s, q, answer_of([&s, w](Index k) {
                      return laplacian_difference(w, s.samples(), s.f, s.measured[k]);
                  })),
        at_places("Brookshaw", true, s, q, answer_of([&s, w](Index k) {
                      return laplacian_brookshaw(w, s.samples(), s.f, s.measured[k]);
                  }))};
    add_shape_functions<K::dim>(all.front(), {SphShape<K>(w, s.samples())}, s, q);
    return all;
}
}  // namespace

template <int Dim>
std::vector<PreparedMethod> sph_methods(const Situation<Dim>& s, Quantity quantity) {
    if (quantity == Quantity::gradient) return sph_gradients(s);
    std::vector<PreparedMethod> all;
    AllKernels::with<Dim>(s.kernel, s.support, [&](const auto& w) {
        all = quantity == Quantity::value ? values(w, s) : laplacians(w, s);
    });
    return all;
}
template std::vector<PreparedMethod> sph_methods(const Situation<2>&, Quantity);
template std::vector<PreparedMethod> sph_methods(const Situation<3>&, Quantity);

}  // namespace benchmarks
