#include "solver/kernels/wendland_c6.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace wendland_c6_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As in Wendland 1995, φ_{1,3} in 1D and φ_{3,3} in 2D and 3D, normalised.
template <int Dim> struct WendlandC6Formula {
    static constexpr int rim_order = Dim == 1 ? 7 : 8;
    static constexpr bool singular = false;

    template <class Real> static Real sigma() {
        return Dim == 1   ? Real(55) / 32
               : Dim == 2 ? 78 / (7 * pi<Real>())
                          : 1365 / (64 * pi<Real>());
    }
    template <class Real> static Real P(const Real& q) {
        using std::pow;
        if (Dim == 1) return pow(1 - q, 7) * (1 + 7 * q + 19 * q * q + 21 * q * q * q);
        return pow(1 - q, 8) * (1 + 8 * q + 25 * q * q + 32 * q * q * q);
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real slope = Dim == 1 ? Real(-6 * q * pow(1 - q, 6) * (3 + 18 * q + 35 * q * q))
                                    : Real(-22 * q * pow(1 - q, 7) * (1 + 7 * q + 16 * q * q));
        return sigma<Real>() / pow(h, Dim + 1) * slope;
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real curvature =
            Dim == 1 ? Real(-18 * pow(1 - q, 5) * (1 + 5 * q - 13 * q * q - 105 * q * q * q))
                     : Real(-22 * pow(1 - q, 6) * (1 + 6 * q - 15 * q * q - 160 * q * q * q));
        return sigma<Real>() / pow(h, Dim + 2) * curvature;
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support);
    }
};

const Register standard_claims{
    kernel_claims<WendlandC6, WendlandC6Formula>({Paper::literature, "Wendland 1995"})};
}  // namespace
}  // namespace wendland_c6_claims
