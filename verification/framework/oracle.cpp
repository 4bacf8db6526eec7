#include "verification/framework/oracle.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace verification {

namespace {
/// Calls panel(from, to) between successive ends.
template <class Real, class Panel>
Real sum_over_panels(Real a, Real b, std::vector<Real> inner, Panel panel) {
    inner.insert(inner.begin(), a);
    inner.push_back(b);
    Real total = 0;
    for (std::size_t k = 1; k < inner.size(); ++k) total += panel(inner[k - 1], inner[k]);
    return total;
}

double call(double x, void* f) {
    return (*static_cast<const std::function<double(double)>*>(f))(x);
}
}  // namespace

double ulp_error(double computed, const Real50& exact) {
    const double rounded = std::abs(exact.convert_to<double>());
    const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
    return abs((Real50(computed) - exact) / Real50(ulp)).convert_to<double>();
}

double integrate(const std::function<double(double)>& f, double a, double b,
                 std::vector<double> breakpoints) {
    constexpr std::size_t max_intervals = 1000;
    const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
        gsl_integration_workspace_alloc(max_intervals), gsl_integration_workspace_free);
    gsl_function integrand{call, const_cast<std::function<double(double)>*>(&f)};
    return sum_over_panels(a, b, std::move(breakpoints), [&](double from, double to) {
        // GSL's default handler ends the program; the status says the same.
        gsl_error_handler_t* const before = gsl_set_error_handler_off();
        double value = 0.0, error = 0.0;
        const int status = gsl_integration_qags(&integrand, from, to, 0.0, 1e-13, max_intervals,
                                                space.get(), &value, &error);
        gsl_set_error_handler(before);
        if (status != GSL_SUCCESS && status != GSL_EROUND)
            throw std::runtime_error(std::string("integrate: ") + gsl_strerror(status));
        return value;
    });
}

Real50 integrate_polynomial(const std::function<Real50(const Real50&)>& f, const Real50& a,
                            const Real50& b, std::vector<Real50> breakpoints) {
    return sum_over_panels(a, b, std::move(breakpoints), [&](const Real50& from, const Real50& to) {
        return boost::math::quadrature::gauss<Real50, 30>::integrate(f, from, to);
    });
}

}  // namespace verification
