#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <boost/math/constants/constants.hpp>

namespace kernel_moments_claims {
namespace {
using namespace verification;

/// Coefficients of ω(q) π in powers of q, for support 1. adams2009 Eqs. 86, 89, 92, 95; Wendland 1995.
const std::vector<double>& coefficients(const std::string& kernel) {
    static const std::map<std::string, std::vector<double>> all = {
        {"poly6_2d", {4, 0, -12, 0, 12, 0, -4}},
        {"poly6_3d", {4.921875, 0, -14.765625, 0, 14.765625, 0, -4.921875}},
        {"spiky_2d", {10, -30, 30, -10}},
        {"spiky_3d", {15, -45, 45, -15}},
        {"wendlandC2_2d", {7, 0, -70, 140, -105, 28}},
        {"wendlandC2_3d", {10.5, 0, -105, 210, -157.5, 42}}};
    return all.at(kernel);
}

/// The n-th derivative of ω, at q.
Real50 derivative(const std::string& kernel, int n, const Real50& q) {
    const auto& c = coefficients(kernel);
    Real50 sum = 0;
    for (int k = static_cast<int>(c.size()) - 1; k >= n; --k) {
        Real50 factor = c[static_cast<std::size_t>(k)];
        for (int m = 0; m < n; ++m) factor *= k - m;
        sum = sum * q + factor;
    }
    return sum / boost::math::constants::pi<Real50>();
}
/// ∫ g(q) dV over the ball of radius 1.
double integral(int dim, const std::function<Real50(const Real50&)>& g) {
    const Real50 pi = boost::math::constants::pi<Real50>();
    const auto shell = [&](const Real50& q) -> Real50 {
        return g(q) * (dim == 2 ? Real50(2 * pi * q) : Real50(4 * pi * q * q));
    };
    return static_cast<double>(integrate_polynomial(shell, 0, 1));
}

enum class Moment {
    norm,
    second,
    gradient,
    literal_laplacian,
    true_laplacian,
    of_second_derivative
};

double moment(const std::string& kernel, int dim, Moment which) {
    const auto w = [&](int n, const Real50& q) { return derivative(kernel, n, q); };
    switch (which) {
        case Moment::norm:
            return integral(dim, [&](const Real50& q) { return w(0, q); });
        case Moment::second:
            return integral(dim, [&](const Real50& q) -> Real50 { return w(0, q) * q * q; });
        case Moment::gradient:
            return integral(dim, [&](const Real50& q) -> Real50 { return -w(1, q) * q / dim; });
        case Moment::literal_laplacian:
            return integral(dim,
                            [&](const Real50& q) -> Real50 { return w(2, q) * q * q / (2 * dim); });
        case Moment::true_laplacian:
            return integral(dim, [&](const Real50& q) -> Real50 {
                return (w(2, q) * q + (dim - 1) * w(1, q)) * q / (2 * dim);
            });
        case Moment::of_second_derivative:
            return integral(dim, [&](const Real50& q) { return w(2, q); });
    }
    return 0;
}

/// "3/14" as a number.
double fraction(const std::string& text) {
    const auto slash = text.find('/');
    const double numerator = std::stod(text);
    return slash == text.npos ? numerator : numerator / std::stod(text.substr(slash + 1));
}

/// The worst of all columns; `laplacian` is what the column of the true one is compared with.
double worst_of(Moment laplacian) {
    const Reference table("kernel_moments");
    double worst = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const std::string& kernel = table.text("kernel")[i];
        const int dim = static_cast<int>(table["dim"][i]);
        const auto compare = [&](double printed, double exact) {
            worst = std::max(worst, std::abs(printed - exact) / std::abs(exact));
        };
        const double m2 = moment(kernel, dim, Moment::second);
        compare(table["norm"][i], moment(kernel, dim, Moment::norm));
        compare(fraction(table.text("m2_exact")[i]), m2);
        compare(table["m2"][i], m2);
        compare(table["axis_variance_x2"][i], m2 / dim);
        compare(table["sigma_over_support"][i], std::sqrt(m2 / dim));
        compare(table["W0"][i], static_cast<double>(derivative(kernel, 0, 0)));
        compare(table["gradient_first_moment"][i], moment(kernel, dim, Moment::gradient));
        compare(fraction(table.text("lap_factor_literal_eq11")[i]),
                moment(kernel, dim, Moment::literal_laplacian));
        compare(table["lap_factor_true_laplacian"][i], moment(kernel, dim, laplacian));
        compare(table["zeroth_moment_of_w_second_derivative"][i],
                moment(kernel, dim, Moment::of_second_derivative));
    }
    return worst;
}

const Register claims_of_kernel_moments{
    Claim{
        .id = "reference_data.kernel_moments",
        .source = {Paper::adams2009, "Eqs. 86-97"},
        .says = "norm, second moment and factors of the Laplacian of six kernels, all ten columns",
        .bound =
            at_most(rounding_to(10), "10 printed digits; integrals of polynomials in 50 digits"),
        .measure = [] { return worst_of(Moment::true_laplacian); },
        .sabotaged = [] { return worst_of(Moment::literal_laplacian); },
        .erratum = 17},
};
}  // namespace
}  // namespace kernel_moments_claims
