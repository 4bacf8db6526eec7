#include "solver/kernels/lucy.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace lucy_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As in Lucy 1977, σ for the support h in each dimension.
template <int Dim> struct LucyFormula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = false;

    template <class Real> static Real sigma() {
        return Dim == 1 ? Real(5) / 4 : Dim == 2 ? 5 / pi<Real>() : 105 / (16 * pi<Real>());
    }
    template <class Real> static Real P(const Real& q) {
        return (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q);
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return sigma<Real>() / pow(h, Dim + 1) * (-12 * q * (1 - q) * (1 - q));
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return sigma<Real>() / pow(h, Dim + 2) * (-12 * (1 - q) * (1 - 3 * q));
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support);
    }
};

const Register standard_claims{
    kernel_claims<Lucy, LucyFormula>({Paper::literature, "Lucy 1977; adams2009 Sec. 2.1"})};
}  // namespace
}  // namespace lucy_claims
