#include "solver/kernels/cubic_spline.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/spiky.h"
#include "solver/kernels/wendland_c2.h"
#include "verification/fluid/dispersion.h"
#include "verification/framework/registry.h"

namespace lattice_instabilities_claims {
namespace {
using namespace plumbline;
using namespace verification;

const Lattice<2> hexagonal = hexagonal_lattice(1.0);

/// ω² h²/c₀² of the most unstable wave on a hexagonal lattice compressed by 1 %, or stretched.
template <template <int> class K> std::vector<double> softest(double compression) {
    std::vector<double> found;
    for (double support = 1.5; support < 3.01; support += 0.1) {
        const K<2> w(support);
        const FluidAtRest fluid = compressed(w, hexagonal, compression);
        found.push_back(support * support * spectrum(w, hexagonal, fluid, 24).smallest);
    }
    return found;
}
template <template <int> class K> double most_stable_support(double compression) {
    const auto found = softest<K>(compression);
    return *std::ranges::max_element(found);
}
/// Of all kernels: the support that is most stable under tension.
double most_stable_under_tension(double compression) {
    return std::max(
        {most_stable_support<Poly6>(compression), most_stable_support<WendlandC2>(compression),
         most_stable_support<CubicSpline>(compression), most_stable_support<Spiky>(compression)});
}

const Register claims_of_instabilities{
    Claim{
        .id = "stability.poly6_pairs",
        .source = {Paper::plumbline, "verification/fluid/dispersion.h"},
        .says =
            "under Eq. 51 with poly6 a hexagonal lattice, compressed by 1 %, is unstable for each "
            "support from 1.5 to 3 spacings: ω² h²/c² of the softest wave, at the best support",
        .bound = at_most(-1e-12, "0 is the border; sums of 40 terms of size 1 are off by 1e-14"),
        .measure = [] { return most_stable_support<Poly6>(0.01); },
        .sabotaged = [] { return most_stable_support<WendlandC2>(0.01); }},
    Claim{.id = "stability.wendland_need_not_pair",
          .source = {Paper::literature, "Dehnen and Aly 2012"},
          .says =
              "with Wendland's kernel there is a support at which the same lattice is stable: ω² "
              "h²/c² of the softest wave, at the best support; with poly6 there is none",
          .bound = at_least(1e-12, "0 is the border; sums of 40 terms of size 1 are off by 1e-14"),
          .measure = [] { return most_stable_support<WendlandC2>(0.01); },
          .sabotaged = [] { return most_stable_support<Poly6>(0.01); }},
    Claim{.id = "stability.tension_clumps",
          .source = {Paper::literature, "Swegle, Hicks and Attaway 1995"},
          .says =
              "stretched by 1 %, a hexagonal lattice is unstable with every kernel and support: ω² "
              "h²/c² of the softest wave, at the best of them",
          .bound = at_most(0.0, "negative is growth"),
          .measure = [] { return most_stable_under_tension(-0.01); },
          .sabotaged = [] { return most_stable_under_tension(0.01); }}};
}  // namespace
}  // namespace lattice_instabilities_claims
