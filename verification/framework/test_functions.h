#pragma once

#include "solver/foundation/types.h"

#include <array>
#include <cmath>

namespace verification {

/// Two waves on [0, 1], of different length so that f is no multiple of its second derivative:
///     f = sin(7x) + 1/2 cos(11x)
/// Dimensionless values of lengths in metres; |f| ≤ 3/2, |f′| < 12.5/m, |f″| < 110/m².
struct Tones {
    static constexpr int dim = 1;

    template <class Real> static Real at(const std::array<Real, 1>& x);

    static double value(const plumbline::Vec<1>& x) { return at<double>({x[0]}); }
    static plumbline::Vec<1> gradient(const plumbline::Vec<1>& x);
    static double laplacian(const plumbline::Vec<1>& x);
};

/// Franke's function on [0, 1]²: two hills, a slope and a dip                       Franke 1979
///     f = 3/4 e^(−(u−2)²/4 − (v−2)²/4) + 3/4 e^(−(u+1)²/49 − (v+1)/10)
///       + 1/2 e^(−(u−7)²/4 − (v−3)²/4) − 1/5 e^(−(u−4)² − (v−7)²),   u = 9x, v = 9y
/// Dimensionless values of lengths in metres; |f| < 1.23, |∇f| < 3.5/m, |Δf| < 66/m².
struct Franke {
    static constexpr int dim = 2;

    /// f(x, y) in any arithmetic, so that exact differentiation can check the rest.
    template <class Real> static Real at(const std::array<Real, 2>& x);

    static double value(const plumbline::Vec<2>& x) { return at<double>({x[0], x[1]}); }
    static plumbline::Vec<2> gradient(const plumbline::Vec<2>& x);
    static double laplacian(const plumbline::Vec<2>& x);
};

/// Two plane waves on [0, 1]³, of different length so that f is no multiple of its Laplacian:
///     f = sin(3x + 2y + z) + 1/2 cos(x − y + 2z)
/// Dimensionless values of lengths in metres; |f| ≤ 3/2, |∇f| < 4.5/m, |Δf| ≤ 17/m².
struct Waves {
    static constexpr int dim = 3;

    template <class Real> static Real at(const std::array<Real, 3>& x);

    static double value(const plumbline::Vec<3>& x) { return at<double>({x[0], x[1], x[2]}); }
    static plumbline::Vec<3> gradient(const plumbline::Vec<3>& x);
    static double laplacian(const plumbline::Vec<3>& x);
};

/// The test function of each dimension.
template <int Dim> struct TestFunctionOf;
template <> struct TestFunctionOf<1> { using type = Tones; };
template <> struct TestFunctionOf<2> { using type = Franke; };
template <> struct TestFunctionOf<3> { using type = Waves; };
template <int Dim> using TestFunction = typename TestFunctionOf<Dim>::type;

template <class Real> Real Tones::at(const std::array<Real, 1>& x) {
    using std::cos;
    using std::sin;
    return sin(Real(7 * x[0])) + cos(Real(11 * x[0])) / 2;
}

template <class Real> Real Franke::at(const std::array<Real, 2>& x) {
    using std::exp;
    const Real u = 9 * x[0], v = 9 * x[1];
    const auto square = [](const Real& s) -> Real { return s * s; };
    return 3 * exp(Real(-(square(u - 2) + square(v - 2)) / 4)) / 4 +
           3 * exp(Real(-square(u + 1) / 49 - (v + 1) / 10)) / 4 +
           exp(Real(-(square(u - 7) + square(v - 3)) / 4)) / 2 -
           exp(Real(-square(u - 4) - square(v - 7))) / 5;
}

template <class Real> Real Waves::at(const std::array<Real, 3>& x) {
    using std::cos;
    using std::sin;
    return sin(Real(3 * x[0] + 2 * x[1] + x[2])) + cos(Real(x[0] - x[1] + 2 * x[2])) / 2;
}

}  // namespace verification
