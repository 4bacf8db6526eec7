#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/brookshaw_laplacian.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/approximation/sph_shape.h"

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Quantity;

template <RadialKernel K>
std::vector<PreparedMethod> values(const K& w, const Situation<K::dim>& s) {
    const auto q = Quantity::value;
    return {at_places(
                "SPH Eq. 3", s, q,
                [&s, w](Index k) { return interpolate(w, s.samples(), s.f, place(s, k)); },
                SphShape<K>(w, s.samples())),
            at_places("Shepard", true, s, q,
                      [&s, w](Index k) { return shepard(w, s.samples(), s.f, place(s, k)); })};
}

template <RadialKernel K>
std::vector<PreparedMethod> laplacians(const K& w, const Situation<K::dim>& s) {
    const auto q = Quantity::laplacian;
    return {at_places(
                "SPH Eq. 11", s, q,
                [&s, w](Index k) { return laplacian_summation(w, s.samples(), s.f, place(s, k)); },
                SphShape<K>(w, s.samples())),
            at_places("SPH Eq. 15", true, s, q,
                      [&s, w](Index k) {
                          return laplacian_difference(w, s.samples(), s.f, s.measured[k]);
                      }),
            at_places("Brookshaw", true, s, q, [&s, w](Index k) {
                return laplacian_brookshaw(w, s.samples(), s.f, s.measured[k]);
            })};
}
}  // namespace

template <int Dim>
std::vector<PreparedMethod> sph_methods(const Situation<Dim>& s, Quantity quantity) {
    if (quantity == Quantity::gradient) return sph_gradients(s);
    std::vector<PreparedMethod> all;
    FrontierKernels::with<Dim>(s.kernel, s.support, [&](const auto& w) {
        all = quantity == Quantity::value ? values(w, s) : laplacians(w, s);
    });
    return all;
}
template std::vector<PreparedMethod> sph_methods(const Situation<2>&, Quantity);
template std::vector<PreparedMethod> sph_methods(const Situation<3>&, Quantity);

}  // namespace benchmarks
