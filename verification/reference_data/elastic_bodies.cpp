#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <Eigen/Dense>
#include <boost/math/constants/constants.hpp>

#include <numbers>

namespace elastic_bodies_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;
using Mat2 = Eigen::Matrix2d;

struct Lame {
    double lambda, mu;
};
Lame lame(double nu) { return {nu / ((1 + nu) * (1 - 2 * nu)), 0.5 / (1 + nu)}; }  // E = 1

/// Strains that the material law is fed with: Green's, or the linear one, wrong here.
template <class M> M green_strain(const M& F) { return 0.5 * (F.transpose() * F - M::Identity()); }
template <class M> M linear_strain(const M& F) { return 0.5 * (F + F.transpose()) - M::Identity(); }

/// S = λ tr(E) I + 2 μ E.                                                    adams2009 Eqs. 61, 62
template <class M> M second_stress(const Lame& m, const M& E) {
    return m.lambda * E.trace() * M::Identity() + 2 * m.mu * E;
}

struct Shear {
    Mat2 S, P, sigma;
    double energy;
};
Shear simple_shear(const Row& r, bool linear) {
    const Lame m = lame(r("nu"));
    Mat2 F = Mat2::Identity();
    F(0, 1) = r("gamma");
    const Mat2 E = linear ? linear_strain(F) : green_strain(F);
    const Mat2 S = second_stress(m, E), P = F * S;
    return {S, P, P * F.transpose(), 0.5 * (S * E).trace()};  // det F = 1
}
double worst_shear(bool linear) {
    const Reference table("svk_simple_shear");
    const auto worst = [&](const char* column, auto part) {
        return worst_difference(table, column,
                                [=](const Row& r) { return part(simple_shear(r, linear)); });
    };
    return std::max({worst("S12", [](const Shear& s) { return s.S(0, 1); }),
                     worst("P12", [](const Shear& s) { return s.P(0, 1); }),
                     worst("P21", [](const Shear& s) { return s.P(1, 0); }),
                     worst("P11", [](const Shear& s) { return s.P(0, 0); }),
                     worst("S22", [](const Shear& s) { return s.S(1, 1); }),
                     worst("sigma12", [](const Shear& s) { return s.sigma(0, 1); }),
                     worst("sigma11_minus_sigma22",
                           [](const Shear& s) { return s.sigma(0, 0) - s.sigma(1, 1); }),
                     worst("energy_density", [](const Shear& s) { return s.energy; })});
}

struct Stretch {
    double transverse, S, P, sigma, P_confined, tangent;
};
/// Axial strain e; free sides strain by −ν e; E = 1.
Stretch uniaxial(const Row& r, bool linear) {
    const double nu = r("nu"), l = r("stretch");
    const Lame m = lame(nu);
    const auto strain = [=](double stretch) {
        return linear ? stretch - 1 : 0.5 * (stretch * stretch - 1);
    };
    const double e = strain(l), transverse = std::sqrt(1 - 2 * nu * e);
    const Eigen::Vector3d E(e, -nu * e, -nu * e);
    const Eigen::Matrix3d S = second_stress<Eigen::Matrix3d>(m, E.asDiagonal());
    const double step =
        1e-4;  // P is a cubic: the central difference is off by step² P‴/6 = step²/2
    const double slope =
        ((l + step) * strain(l + step) - (l - step) * strain(l - step)) / (2 * step);
    return {transverse,
            S(0, 0),
            l * S(0, 0),
            l * S(0, 0) / (transverse * transverse),
            l * (m.lambda + 2 * m.mu) * e,
            slope - step * step / 2};
}
double worst_uniaxial(bool linear) {
    const Reference table("svk_uniaxial");
    const auto worst = [&](const char* column, double Stretch::*part) {
        return worst_difference(
            table, column, [=](const Row& r) { return uniaxial(r, linear).*part; }, 0.01);
    };
    return std::max({worst("S_uniaxial_stress", &Stretch::S),
                     worst("P_uniaxial_stress", &Stretch::P),
                     worst("sigma_uniaxial_stress", &Stretch::sigma),
                     worst("transverse_stretch", &Stretch::transverse),
                     worst("P_uniaxial_strain", &Stretch::P_confined),
                     worst("tangent_dP_dl_uniaxial_stress", &Stretch::tangent)});
}

double rigid_rotation(bool linear) {
    const Reference table("rigid_rotation_strain");
    const auto F = [](const Row& r) {
        return Eigen::Rotation2Dd(r("deg") * std::numbers::pi / 180).toRotationMatrix();
    };
    const double of_linear = worst_difference(table, "linear_strain_eps11", [&](const Row& r) {
        return linear_strain<Mat2>(F(r))(0, 0);
    });
    const double of_green = worst_difference(
        table, "green_strain",
        [&](const Row& r) {
            return (linear ? linear_strain<Mat2>(F(r)) : green_strain<Mat2>(F(r))).norm();
        },
        1.0);
    return std::max(of_linear, of_green);
}

// The manufactured solid in 50 digits, so that differences for −Div P are as good as derivatives.
using Mat50 = Eigen::Matrix<Real50, 2, 2>;
const Real50 pi50 = boost::math::constants::pi<Real50>();

Mat50 manufactured_stress(const Real50& x, const Real50& y, bool linear) {
    const Real50 A = Real50(1) / 20, lambda = Real50(6) / 5, mu = Real50(4) / 5;
    Mat50 F;
    F << 1 + A * pi50 * cos(pi50 * x) * sin(pi50 * y), A * pi50 * sin(pi50 * x) * cos(pi50 * y),
        2 * A * pi50 * cos(2 * pi50 * x) * sin(pi50 * y),
        1 + A * pi50 * sin(2 * pi50 * x) * cos(pi50 * y);
    Mat50 E = F.transpose() * F - Mat50::Identity();
    E /= Real50(2);
    if (linear) {
        E = F + F.transpose() - 2 * Mat50::Identity();
        E /= Real50(2);
    }
    const Mat50 S = lambda * E.trace() * Mat50::Identity() + 2 * mu * E;
    return F * S;
}
double body_force(const Row& r, int i, bool linear) {
    const Real50 h = 1e-15, x = Real50(std::to_string(r("x"))), y = Real50(std::to_string(r("y")));
    const auto P = [&](const Real50& dx, const Real50& dy, int j) -> Real50 {
        return manufactured_stress(x + dx, y + dy, linear)(i, j);
    };
    return static_cast<double>((P(-h, 0, 0) - P(h, 0, 0) + P(0, -h, 1) - P(0, h, 1)) / (2 * h));
}
double worst_manufactured(bool linear) {
    const Reference table("mms_svk_plane_strain");
    const char* stresses[] = {"P11", "P12", "P21", "P22"};
    double worst = 0;
    for (int k = 0; k < 4; ++k)
        worst = std::max(worst, worst_difference(
                                    table, stresses[k],
                                    [=](const Row& r) {
                                        return static_cast<double>(manufactured_stress(
                                            Real50(std::to_string(r("x"))),
                                            Real50(std::to_string(r("y"))), linear)(k / 2, k % 2));
                                    },
                                    1e-3));
    for (const int i : {0, 1})
        worst = std::max(worst, worst_difference(table, i == 0 ? "b_x" : "b_y", [=](const Row& r) {
                             return body_force(r, i, linear);
                         }));
    const double pi = std::numbers::pi;
    return std::max(
        {worst,
         worst_difference(
             table, "u_x",
             [=](const Row& r) { return 0.05 * std::sin(pi * r("x")) * std::sin(pi * r("y")); },
             1e-3),
         worst_difference(
             table, "u_y",
             [=](const Row& r) { return 0.05 * std::sin(2 * pi * r("x")) * std::sin(pi * r("y")); },
             1e-3)});
}

const Register claims_of_elastic_bodies{
    Claim{.id = "reference_data.svk_simple_shear",
          .source = {Paper::adams2009, "Eqs. 61, 62"},
          .says = "stresses and energy of a sheared block, from the tensors themselves",
          .bound = at_most(1e-9,
                           "12 printed digits; at a shear of 0.001 strains of 5e-7 are left of "
                           "numbers near 1: 1.1e-16 · 2 / 5e-7 = 4.4e-10"),
          .measure = [] { return worst_shear(false); },
          .sabotaged = [] { return worst_shear(true); }},
    Claim{.id = "reference_data.svk_uniaxial",
          .source = {Paper::adams2009, "Eqs. 61, 62"},
          .says = "stresses, side stretch and tangent of a pulled or pressed bar",
          .bound = at_most(1e-9,
                           "12 printed digits; the tangent is a difference over 2e-4 of values "
                           "up to 3: 3 · 1.1e-16 / 1e-4 = 3.3e-12, of 0.01 at least"),
          .measure = [] { return worst_uniaxial(false); },
          .sabotaged = [] { return worst_uniaxial(true); }},
    Claim{.id = "reference_data.rigid_rotation_strain",
          .source = {Paper::adams2009, "Eq. 61"},
          .says = "a rotation strains nothing by Green's measure, 1 − cos by the linear one",
          .bound = at_most(1e-10,
                           "12 printed digits; at 0.1 degrees cos − 1 = 1.5e-6 is left of 1: "
                           "1.1e-16 / 1.5e-6 = 7.3e-11"),
          .measure = [] { return rigid_rotation(false); },
          .sabotaged = [] { return rigid_rotation(true); }},
    Claim{.id = "reference_data.manufactured_solid",
          .source = {Paper::adams2009, "Eqs. 61, 62"},
          .says = "b = −Div P of the displacement in the file, and P itself",
          .bound = at_most(1e-12,
                           "14 printed digits of values from 1e-3 on that are sums of terms up "
                           "to 1, in double precision: 10 · 1.1e-16 / 1e-3"),
          .measure = [] { return worst_manufactured(false); },
          .sabotaged = [] { return worst_manufactured(true); }},
};
}  // namespace
}  // namespace elastic_bodies_claims
