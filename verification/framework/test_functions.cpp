#include "verification/framework/test_functions.h"

#include "solver/foundation/random.h"
#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"

namespace verification {

namespace {
using plumbline::Vec;

/// a e^(−g) with ∂g/∂x, ∂g/∂y and Δg = curvature: the terms of Franke's function.
struct Term {
    double value;
    Vec<2> slope;
    double curvature;
};

std::array<Term, 4> terms_of_franke(const Vec<2>& x) {
    const double u = 9 * x[0], v = 9 * x[1];
    const auto square = [](double s) { return s * s; };
    return {
        {{0.75 * std::exp(-(square(u - 2) + square(v - 2)) / 4),
          {4.5 * (u - 2), 4.5 * (v - 2)},
          81},
         {0.75 * std::exp(-square(u + 1) / 49 - (v + 1) / 10),
          {18 * (u + 1) / 49, 0.9},
          162.0 / 49},
         {0.5 * std::exp(-(square(u - 7) + square(v - 3)) / 4), {4.5 * (u - 7), 4.5 * (v - 3)}, 81},
         {-0.2 * std::exp(-square(u - 4) - square(v - 7)), {18 * (u - 4), 18 * (v - 7)}, 324}}};
}

const Vec<3> long_wave(3, 2, 1), short_wave(1, -1, 2);

/// Central differences in 50 digits. Of the first derivative with step 10⁻¹⁴, of the second with
/// 10⁻¹¹: what they leave out is below 10⁻²² and 10⁻¹⁶ times the fourth derivative, rounding less.
template <class F> struct Differences {
    static constexpr int dim = F::dim;
    std::array<Real50, dim> x;

    explicit Differences(const Vec<dim>& point) {
        for (int d = 0; d < dim; ++d) x[d] = point[d];
    }
    Real50 moved(int d, const Real50& step) const {
        auto y = x;
        y[d] += step;
        return F::at(y);
    }
    double first(int d) const {
        const Real50 step("1e-14");
        return static_cast<double>((moved(d, step) - moved(d, -step)) / (2 * step));
    }
    double sum_of_second() const {
        const Real50 step("1e-11"), centre = F::at(x);
        Real50 sum = 0;
        for (int d = 0; d < dim; ++d)
            sum += (moved(d, step) - 2 * centre + moved(d, -step)) / (step * step);
        return static_cast<double>(sum);
    }
};

/// The largest of error(point) over 200 points of the unit box.
template <int Dim, class Error> double worst(Error error) {
    plumbline::Random random(1979);
    double largest = 0;
    for (int k = 0; k < 200; ++k) {
        Vec<Dim> x;
        for (int d = 0; d < Dim; ++d) x[d] = random.uniform();
        largest = std::max(largest, error(x));
    }
    return largest;
}

template <class F> double gradient_error(Vec<F::dim> (*gradient)(const Vec<F::dim>&)) {
    return worst<F::dim>([&](const Vec<F::dim>& x) {
        const Differences<F> exact(x);
        double largest = 0;
        for (int d = 0; d < F::dim; ++d)
            largest = std::max(largest, std::abs(gradient(x)[d] - exact.first(d)));
        return largest;
    });
}

template <class F> double laplacian_error(double (*laplacian)(const Vec<F::dim>&)) {
    return worst<F::dim>([&](const Vec<F::dim>& x) {
        return std::abs(laplacian(x) - Differences<F>(x).sum_of_second());
    });
}

/// What one might write instead of a derivative: differences in double precision.
constexpr double step = 1e-4;

template <class F> Vec<F::dim> difference_gradient(const Vec<F::dim>& x) {
    Vec<F::dim> gradient;
    for (int d = 0; d < F::dim; ++d) {
        const Vec<F::dim> e = step * Vec<F::dim>::Unit(d);
        gradient[d] = (F::value(x + e) - F::value(x - e)) / (2 * step);
    }
    return gradient;
}

template <class F> double difference_laplacian(const Vec<F::dim>& x) {
    double sum = 0;
    for (int d = 0; d < F::dim; ++d) {
        const Vec<F::dim> e = step * Vec<F::dim>::Unit(d);
        sum += (F::value(x + e) - 2 * F::value(x) + F::value(x - e)) / (step * step);
    }
    return sum;
}

constexpr auto why_gradient =
    "rounding: at most 4 terms, each at most 7/m with about 15 roundings of 1.1e-16: 5e-14";
constexpr auto why_laplacian =
    "rounding: at most 4 terms, each at most 65/m² with about 15 roundings of 1.1e-16: 4e-13";

template <class F> Claim gradient_claim(const std::string& name) {
    return {.id = "test_functions.gradient_of_" + name,
            .source = {Paper::plumbline, "docstrings of test_functions.h"},
            .says = "the gradient of " + name + " is that of its value, by 50-digit differences",
            .bound = at_most(1e-13, why_gradient),
            .measure = [] { return gradient_error<F>(F::gradient); },
            .sabotaged = [] { return gradient_error<F>(difference_gradient<F>); }};
}

template <class F> Claim laplacian_claim(const std::string& name) {
    return {.id = "test_functions.laplacian_of_" + name,
            .source = {Paper::plumbline, "docstrings of test_functions.h"},
            .says = "the Laplacian of " + name + " is that of its value, by 50-digit differences",
            .bound = at_most(1e-12, why_laplacian),
            .measure = [] { return laplacian_error<F>(F::laplacian); },
            .sabotaged = [] { return laplacian_error<F>(difference_laplacian<F>); }};
}

const Register claims_of_test_functions{
    gradient_claim<Tones>("tones"),   laplacian_claim<Tones>("tones"),
    gradient_claim<Franke>("franke"), laplacian_claim<Franke>("franke"),
    gradient_claim<Waves>("waves"),   laplacian_claim<Waves>("waves")};
}  // namespace

Vec<1> Tones::gradient(const Vec<1>& x) {
    return Vec<1>(7 * std::cos(7 * x[0]) - 5.5 * std::sin(11 * x[0]));
}
double Tones::laplacian(const Vec<1>& x) {
    return -49 * std::sin(7 * x[0]) - 60.5 * std::cos(11 * x[0]);
}

Vec<2> Franke::gradient(const Vec<2>& x) {
    Vec<2> sum = Vec<2>::Zero();
    for (const Term& t : terms_of_franke(x)) sum -= t.value * t.slope;
    return sum;
}
double Franke::laplacian(const Vec<2>& x) {
    double sum = 0;
    for (const Term& t : terms_of_franke(x)) sum += t.value * (t.slope.squaredNorm() - t.curvature);
    return sum;
}

Vec<3> Waves::gradient(const Vec<3>& x) {
    return std::cos(long_wave.dot(x)) * long_wave - 0.5 * std::sin(short_wave.dot(x)) * short_wave;
}
double Waves::laplacian(const Vec<3>& x) {
    return -long_wave.squaredNorm() * std::sin(long_wave.dot(x)) -
           0.5 * short_wave.squaredNorm() * std::cos(short_wave.dot(x));
}

}  // namespace verification
