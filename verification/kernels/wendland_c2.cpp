#include "solver/kernels/wendland_c2.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace wendland_c2_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As in Wendland 1995, φ_{1,1} in 1D and φ_{3,1} in 2D and 3D, normalised.
template <int Dim> struct WendlandC2Formula {
    static constexpr int rim_order = Dim == 1 ? 3 : 4;
    static constexpr bool singular = false;

    template <class Real> static Real sigma() {
        return Dim == 1 ? Real(5) / 4 : Dim == 2 ? 7 / pi<Real>() : 21 / (2 * pi<Real>());
    }
    template <class Real> static Real P(const Real& q) {
        using std::pow;
        if (Dim == 1) return pow(1 - q, 3) * (1 + 3 * q);
        return pow(1 - q, 4) * (1 + 4 * q);
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real slope = Dim == 1 ? Real(-12 * q * pow(1 - q, 2)) : Real(-20 * q * pow(1 - q, 3));
        return sigma<Real>() / pow(h, Dim + 1) * slope;
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real curvature =
            Dim == 1 ? Real(-12 * (1 - q) * (1 - 3 * q)) : Real(-20 * pow(1 - q, 2) * (1 - 4 * q));
        return sigma<Real>() / pow(h, Dim + 2) * curvature;
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support);
    }
};

const Register standard_claims{
    kernel_claims<WendlandC2, WendlandC2Formula>({Paper::literature, "Wendland 1995"})};
}  // namespace
}  // namespace wendland_c2_claims
