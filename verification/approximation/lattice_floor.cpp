#include "solver/approximation/sph_interpolation.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/approximation_errors.h"
#include "verification/framework/patch.h"
#include "verification/framework/registry.h"

#include <cmath>
#include <map>
#include <numeric>

// Eq. 3 on a lattice with the spacing 1: Σ ω(x − xⱼ) = Σ ω̂(G) e^(i G·x) over the reciprocal lattice
// G = 2π n (Poisson). The volumes m/ρ of Eqs. 4, 5 divide by its value S at the points of the lattice,
// where it is largest or least, so that ⟨1⟩(x) − 1 = Σ ω̂(G) (e^(i G·x) − 1) / S over G ≠ 0: nothing at the
// points, and between them what no refinement at fixed h/spacing takes away.
namespace lattice_floor_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// ω̂ of poly6, (1 − q²)³ normalised: Γ(ν + 1) (2/κ)^ν J_ν(κ), ν = 3 + Dim/2, κ = h |G|.
template <int Dim> double fourier(double kappa) {
    constexpr double nu = 3.0 + 0.5 * Dim;
    return std::tgamma(nu + 1.0) * std::pow(2.0 / kappa, nu) * std::cyl_bessel_j(nu, kappa);
}

/// Mean and mean square of ⟨1⟩ − 1 over a cell.
struct Floor {
    double mean, square;
};
constexpr int furthest = 40;  // |n| of the reciprocal lattice vectors that are summed

/// How many n ≠ 0 of the whole numbers to the power Dim have |n|² = each number up to furthest².
template <int Dim> std::map<int, int> shells() {
    std::map<int, int> found{{0, 1}};
    for (int d = 0; d < Dim; ++d) {
        std::map<int, int> wider;
        for (const auto& [square, n] : found)
            for (int k = -furthest; k <= furthest; ++k)
                if (square + k * k <= furthest * furthest) wider[square + k * k] += n;
        found = std::move(wider);
    }
    found.erase(0);
    return found;
}

/// By Poisson's sum, for a support of `h` spacings.
template <int Dim> Floor predicted(double h) {
    double sum = 0.0, squares = 0.0;
    for (const auto& [square, n] : shells<Dim>()) {
        const double w = fourier<Dim>(2.0 * std::numbers::pi * h * std::sqrt(square));
        sum += n * w;
        squares += n * w * w;
    }
    const double S = 1.0 + sum;
    return {-sum / S, (squares + sum * sum) / (S * S)};
}

/// By Eq. 3 at n^Dim places evenly spread over a cell; `n` = 1: at a point of the lattice only.
template <int Dim> Floor measured(double h, int n) {
    const Patch<Dim> patch(cubic_lattice<Dim>(1.0), {.support = h, .reach = 1.8});
    const Poly6<Dim> w(h);
    std::vector<Index> everyone(patch.x.size());
    std::iota(everyone.begin(), everyone.end(), Index{0});
    const std::vector<double> one(patch.x.size(), 1.0);
    const auto sum_at = [&](const Vec<Dim>& x) {
        return interpolate<Poly6<Dim>>(w, patch.samples(), one, {x, everyone});
    };
    const double S = sum_at(Vec<Dim>::Zero());
    Floor floor{0.0, 0.0};
    const int places = static_cast<int>(std::lround(std::pow(n, Dim)));
    for (int k = 0; k < places; ++k) {
        Vec<Dim> x;
        for (int d = 0, rest = k; d < Dim; ++d, rest /= n) x[d] = static_cast<double>(rest % n) / n;
        const double error = sum_at(x) / S - 1.0;
        floor.mean += error / places;
        floor.square += error * error / places;
    }
    return floor;
}

template <int Dim> double measured_over_predicted(double h, int n) {
    return std::sqrt(measured<Dim>(h, n).square / predicted<Dim>(h).square);
}

constexpr double h_in_plane = 2.8;
const Approximation eq_3{Quantity::value, "SPH Eq. 3"};

double squared_error_of_franke(int per_metre, MeasuredAt measured_at) {
    constexpr int seeds = 3;
    double squares = 0.0;
    for (int seed = 1; seed <= seeds; ++seed)
        squares += std::pow(errors_of<2>({Sampling::lattice, Region::interior, 1.0 / per_metre,
                                          h_in_plane / per_metre, static_cast<std::uint64_t>(seed),
                                          measured_at},
                                         eq_3)
                                .l2,
                            2) /
                   seeds;
    return squares;
}

/// ⟨f⟩ − f = e f + h² Δf / 20 with e = ⟨1⟩ − 1, which is independent of f; the variance of poly6 along
/// an axis is h² / 10.
double predicted_squared_error_of_franke(int per_metre) {
    const Floor e = predicted<2>(h_in_plane);
    const double c = std::pow(h_in_plane / per_metre, 2) / 20.0;
    constexpr int n = 300;
    double squares = 0.0;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const Vec<2> x((column + 0.5) / n, (row + 0.5) / n);
            const double f = Franke::value(x), smoothed = c * Franke::laplacian(x);
            squares +=
                (e.square * f * f + 2.0 * e.mean * f * smoothed + smoothed * smoothed) / (n * n);
        }
    return squares;
}

double order_of_franke(MeasuredAt measured_at) {
    return std::log2(squared_error_of_franke(200, measured_at) /
                     squared_error_of_franke(400, measured_at)) /
           2.0;
}

constexpr auto why_ratio_of_1d =
    "1: both are the same number; Σ beyond n = 40 of |ω̂| ≤ 105 κ^-4 is 1e-8 of 1e-3";

const Register claims_of_lattice_floor{
    Claim{.id = "lattice_floor.is_that_of_poisson_1d",
          .source = {Paper::adams2009, "Eqs. 3, 4"},
          .says = "rms of ⟨1⟩ − 1 between the points of a line, h = 2.8 spacings, over that of "
                  "Poisson's sum",
          .bound = between(0.999, 1.001, why_ratio_of_1d),
          .measure = [] { return measured_over_predicted<1>(2.8, 16); },
          .sabotaged = [] { return measured_over_predicted<1>(2.8, 1); }},
    Claim{.id = "lattice_floor.is_that_of_poisson_2d",
          .source = {Paper::adams2009, "Eqs. 3, 4"},
          .says = "rms of ⟨1⟩ − 1 between the points of a square lattice, h = 2.8 spacings, over "
                  "that of Poisson's sum; measured at the points alone it would be 0",
          .bound = between(0.999, 1.001,
                           "1: both are the same number; Σ beyond |n| = 40 of |ω̂| ≤ 307 κ^-4.5 is "
                           "2e-7 of 5e-4"),
          .measure = [] { return measured_over_predicted<2>(h_in_plane, 16); },
          .sabotaged = [] { return measured_over_predicted<2>(h_in_plane, 1); }},
    Claim{.id = "lattice_floor.is_that_of_poisson_3d",
          .source = {Paper::adams2009, "Eqs. 3, 4"},
          .says = "rms of ⟨1⟩ − 1 between the points of a cubic lattice, h = 2.5 spacings, over "
                  "that of Poisson's sum",
          .bound = between(0.99, 1.01,
                           "1: both are the same number; Σ beyond |n| = 40 of |ω̂| ≤ 945 κ^-5 is "
                           "4e-6 of 1e-3"),
          .measure = [] { return measured_over_predicted<3>(2.5, 8); },
          .sabotaged = [] { return measured_over_predicted<3>(2.5, 1); }},
    Claim{.id = "lattice_floor.order_at_samples",
          .source = {Paper::adams2009, "Eq. 3; Sec. 2.1"},
          .says =
              "Eq. 3 at the points of a square lattice, h = 2.8 spacings: order from 200 to 400 "
              "points per metre, Franke's function; between the points it rests",
          .bound = between(1.9, 2.1,
                           "2 by smoothing; the next term is k²h²/48 with k = 25/m and h = 1.4 cm, "
                           "0.3 %, which moves the order by 0.003; 6000 samples with squares that "
                           "vary by twice their mean: 1.3 % at each level, 0.026 of the order"),
          .measure = [] { return order_of_franke(MeasuredAt::samples); },
          .sabotaged = [] { return order_of_franke(MeasuredAt::between); }},
    Claim{
        .id = "lattice_floor.of_franke",
        .source = {Paper::adams2009, "Eq. 3; Sec. 2.1"},
        .says = "Eq. 3 between the points of a square lattice, h = 2.8 spacings, 400 per metre: "
                "rms error of Franke's function over Poisson's floor times rms f, with smoothing",
        .bound = between(0.95, 1.05,
                         "6000 places with squares that vary by twice their mean: 1.3 %; what the "
                         "first moment of the lattice adds to f is left out, h |∇f| of f: 2e-3 of "
                         "the squares"),
        .measure =
            [] {
                return std::sqrt(squared_error_of_franke(400, MeasuredAt::between) /
                                 predicted_squared_error_of_franke(400));
            },
        .sabotaged =
            [] {
                return std::sqrt(squared_error_of_franke(400, MeasuredAt::samples) /
                                 predicted_squared_error_of_franke(400));
            }},
};
}  // namespace
}  // namespace lattice_floor_claims
