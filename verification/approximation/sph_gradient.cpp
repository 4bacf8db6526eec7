#include "solver/approximation/sph_gradient.h"

#include "solver/approximation/density.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/patch.h"
#include "verification/framework/registry.h"

namespace {
using namespace plumbline;
using namespace verification;

const Poly6<2> w(2.5);
const Patch<2>& jittered() {
    static const Patch<2> patch(cubic_lattice<2>(1.0), {.support = w.support(), .jitter = 0.2});
    return patch;
}

double constant_by_difference() {
    const auto f = jittered().sample([](const Vec<2>&) { return 7.0; });
    return gradient_difference(w, jittered().samples(), f, jittered().centre).norm();
}
double constant_by_summation() {
    const auto f = jittered().sample([](const Vec<2>&) { return 7.0; });
    const auto s = jittered().samples();
    return gradient_summation(w, s, f, s.at(jittered().centre)).norm();
}

const Register claims_of_sph_gradient{
    Claim{.id = "sph_gradient.difference_form_kills_constants",
          .source = {Paper::adams2009, "Eq. 13"},
          .says = "subtracting fᵢ makes the gradient of a constant vanish, on any samples",
          .bound = at_most(0.0, "every term has the factor fⱼ − fᵢ, which is 0 exactly"),
          .measure = constant_by_difference,
          .sabotaged = constant_by_summation},
};
}  // namespace
