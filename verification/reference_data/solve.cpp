#include "verification/reference_data/solve.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <memory>
#include <stdexcept>

namespace verification {

namespace {
using Function = std::function<double(double)>;
using Rates = std::function<void(double, const double[], double[])>;

double call(double x, void* f) { return (*static_cast<const Function*>(f))(x); }
int call_rates(double t, const double y[], double rates[], void* f) {
    (*static_cast<const Rates*>(f))(t, y, rates);
    return GSL_SUCCESS;
}
void require_success(int status) {
    if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
}

/// GSL ends the program on an error unless told otherwise.
class NoAbort {
public:
    NoAbort() : before_{gsl_set_error_handler_off()} {}
    ~NoAbort() { gsl_set_error_handler(before_); }
    NoAbort(const NoAbort&) = delete;
    NoAbort& operator=(const NoAbort&) = delete;

private:
    gsl_error_handler_t* before_;
};
}  // namespace

double root(const Function& f, double low, double high) {
    const NoAbort no_abort;
    Function copy = f;
    gsl_function function{call, &copy};
    const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    require_success(gsl_root_fsolver_set(solver.get(), &function, low, high));
    constexpr int most_steps = 200;
    for (int k = 0; k < most_steps; ++k) {
        require_success(gsl_root_fsolver_iterate(solver.get()));
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(a, b, 0, 1e-15) == GSL_SUCCESS) break;
    }
    return gsl_root_fsolver_root(solver.get());
}

std::vector<double> solve_ode(const Rates& rates, std::vector<double> start, double end) {
    const NoAbort no_abort;
    Rates copy = rates;
    gsl_odeiv2_system system{call_rates, nullptr, start.size(), &copy};
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.01 * end, 1e-17, 1e-14),
        gsl_odeiv2_driver_free);
    double t = 0;
    if (end > 0) require_success(gsl_odeiv2_driver_apply(driver.get(), &t, end, start.data()));
    return start;
}

}  // namespace verification
