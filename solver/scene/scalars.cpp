#include "solver/scene/scalars.h"

#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"

namespace plumbline {

namespace {
Vec<3> vector_of(std::span<const double> numbers, int dim, std::size_t i) {
    Vec<3> v = Vec<3>::Zero();
    for (int d = 0; d < dim; ++d) v[d] = numbers[i * static_cast<std::size_t>(dim) + d];
    return v;
}
Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Against gravity; the last axis where there is none.
Vec<3> upwards(const SceneFile& scene) {
    const double g = scene.gravity.norm();
    if (g > 0.0) return -scene.gravity / g;
    return Vec<3>::Unit(scene.dim - 1);
}

template <int Dim> double averaged(const Probe& probe, double support, const Snapshot& s) {
    const WendlandC2<Dim> w(support);
    double sum = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double r = (vector_of(s.x, s.dim, i) - probe.at).norm();
        if (r >= support) continue;
        const double weight = s.m[i] / s.rho[i] * w.value(r);
        const double f = probe.quantity == Probe::Quantity::pressure ? s.p[i]
                         : probe.quantity == Probe::Quantity::density
                             ? s.rho[i]
                             : vector_of(s.v, s.dim, i).norm();
        sum += weight * f, weights += weight;
    }
    return weights > 0.0 ? sum / weights : 0.0;
}
double height(const Probe& probe, const SceneFile& scene, const Snapshot& s) {
    const Vec<3> up = upwards(scene);
    double highest = NAN;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Vec<3> x = vector_of(s.x, s.dim, i), from = x - probe.at;
        if ((from - up.dot(from) * up).norm() >= 0.5 * scene.support) continue;
        if (!(up.dot(x) <= highest)) highest = up.dot(x);
    }
    return highest;
}
}  // namespace

Scalars scalars_of(const SceneFile& scene, const Snapshot& s) {
    const TaitEquation tait(scene.density, scene.speed_of_sound, scene.exponent);
    const Vec<3> up = upwards(scene);
    Scalars all;
    double mass = 0.0;
    all.front = all.height = -HUGE_VAL;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Vec<3> x = vector_of(s.x, s.dim, i), v = vector_of(s.v, s.dim, i);
        const double m = s.m[i];
        mass += m;
        all.kinetic += 0.5 * m * v.squaredNorm();
        all.potential -= m * scene.gravity.dot(x);
        if (scene.method != Method::dfsph) all.internal += m * tait.energy(s.rho[i]);
        all.momentum += m * v;
        all.angular_momentum += m * cross(x, v);
        all.centre += m * x;
        all.front = std::max(all.front, x[0]);
        all.height = std::max(all.height, up.dot(x));
        all.largest_speed = std::max(all.largest_speed, v.norm());
    }
    if (mass > 0.0) all.centre /= mass;
    return all;
}

double reading(const Probe& probe, const SceneFile& scene, const Snapshot& particles) {
    if (probe.quantity == Probe::Quantity::height) return height(probe, scene, particles);
    return scene.dim == 2 ? averaged<2>(probe, scene.support, particles)
                          : averaged<3>(probe, scene.support, particles);
}

}  // namespace plumbline
