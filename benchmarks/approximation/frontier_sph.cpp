#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/brookshaw_laplacian.h"
#include "solver/approximation/mueller_gradient.h"
#include "solver/approximation/product_rule_gradient.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/approximation/sph_interpolation.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/approximation/sph_shape.h"

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Quantity;

/// A method given by what it says at place k.
template <class Op>
PreparedMethod at_places(std::string name, bool reads_volumes, const Situation& s,
                         Quantity quantity, Op op) {
    const auto width = static_cast<std::size_t>(components_of(quantity));
    return {std::move(name), reads_volumes, [&s, op, width](std::span<double> out) {
                std::size_t failures = 0;
                for (Index k = 0; k < s.places.size(); ++k)
                    failures += write(op(k), &out[k * width]);
                return failures;
            }};
}

/// The same, with the shape functions that give it, to be computed once.
template <class Op, class Shape>
PreparedMethod at_places(std::string name, const Situation& s, Quantity quantity, Op op,
                         const Shape& shape) {
    PreparedMethod method = at_places(std::move(name), true, s, quantity, op);
    add_shape_functions(method, shape, s, quantity);
    return method;
}

Place<2> place(const Situation& s, Index k) { return {s.places[k], s.rows.of(k)}; }

template <RadialKernel K> std::vector<PreparedMethod> values(const K& w, const Situation& s) {
    const auto q = Quantity::value;
    return {at_places(
                "SPH Eq. 3", s, q,
                [&s, w](Index k) { return interpolate(w, s.samples(), s.f, place(s, k)); },
                SphShape<K>(w, s.samples())),
            at_places("Shepard", true, s, q,
                      [&s, w](Index k) { return shepard(w, s.samples(), s.f, place(s, k)); })};
}

template <RadialKernel K> std::vector<PreparedMethod> gradients(const K& w, const Situation& s) {
    const auto q = Quantity::gradient;
    std::vector<PreparedMethod> all{
        at_places(
            "SPH Eq. 9", s, q,
            [&s, w](Index k) { return gradient_summation(w, s.samples(), s.f, place(s, k)); },
            SphShape<K>(w, s.samples())),
        at_places(
            "SPH Eq. 13", true, s, q,
            [&s, w](Index k) { return gradient_difference(w, s.samples(), s.f, s.measured[k]); }),
        at_places("SPH Eq. 17", true, s, q,
                  [&s, w](Index k) {
                      return gradient_mass_weighted(w, s.samples(), s.m, s.rho, s.f, s.measured[k]);
                  }),
        at_places("SPH Eq. 19", true, s, q, [&s, w](Index k) {
            return gradient_symmetric(w, s.samples(), s.m, s.rho, s.f, s.measured[k]);
        })};
    PreparedMethod mueller = at_places("Mueller", false, s, q, [&s, w](Index k) {
        return mueller_gradient(w, s.samples(), s.f, s.measured[k]);
    });
    add_shape_functions(mueller, MuellerShape<K>(w), s, q);
    all.push_back(std::move(mueller));
    return all;
}

template <RadialKernel K> std::vector<PreparedMethod> laplacians(const K& w, const Situation& s) {
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

std::vector<PreparedMethod> sph_methods(const Situation& s, Quantity quantity) {
    std::vector<PreparedMethod> all;
    FrontierKernels::with<2>(s.kernel, s.support, [&](const auto& w) {
        switch (quantity) {
            case Quantity::value:
                all = values(w, s);
                break;
            case Quantity::gradient:
                all = gradients(w, s);
                break;
            case Quantity::laplacian:
                all = laplacians(w, s);
                break;
        }
    });
    return all;
}

}  // namespace benchmarks
