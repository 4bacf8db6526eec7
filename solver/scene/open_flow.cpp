#include "solver/scene/open_flow.h"

#include <Eigen/Geometry>

#include <array>

namespace plumbline {

namespace {
/// Unit vectors across a direction.
std::array<Vec<2>, 1> across(const Vec<2>& n) { return {Vec<2>(-n[1], n[0])}; }
std::array<Vec<3>, 2> across(const Vec<3>& n) {
    int least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vec<3> one = n.cross(Vec<3>::Unit(least)).normalized();
    return {one, n.cross(one)};
}
/// The particles that a new one near the emitter could meet.
template <int Dim>
std::vector<Vec<Dim>> near_inlet(const Emitter<Dim>& e, const Positions<Dim>& x, double depth) {
    std::vector<Vec<Dim>> found;
    for (const Vec<Dim>& x_i : x) {
        const double ahead = e.direction.dot(x_i - e.centre);
        if (ahead > -e.spacing && ahead < depth) found.push_back(x_i);
    }
    return found;
}
}  // namespace

template <int Dim> Points<Dim> layer_of(const Emitter<Dim>& e) {
    const double d = e.spacing;
    const auto axes = across(e.direction);
    if constexpr (Dim == 2) {
        const auto n = std::max(1.0, std::floor(2.0 * e.radius / d + 1e-6));
        Points<Dim> places;
        for (double k = 0.0; k < n; ++k) places.push_back((k + 0.5 - 0.5 * n) * d * axes[0]);
        return places;
    } else {
        const double half = std::ceil(e.radius / d);
        Points<Dim> places;
        for (double a = -half; a < half; ++a)
            for (double b = -half; b < half; ++b) {
                const Vec<3> x = (a + 0.5) * d * axes[0] + (b + 0.5) * d * axes[1];
                if (x.norm() < e.radius) places.push_back(x);
            }
        return places;
    }
}

template <int Dim>
std::optional<std::vector<Index>> OpenFlow<Dim>::staying(const Positions<Dim>& x, const Masses& m,
                                                         OutflowStates& states) const {
    if (outflows.empty()) return std::nullopt;
    std::vector<Index> stay;
    for (Index i = 0; i < x.size(); ++i) {
        std::size_t k = 0;
        while (k < outflows.size() && from_surface<Dim>(outflows[k], x[i]).distance >= 0.0) ++k;
        if (k == outflows.size())
            stay.push_back(i);
        else
            ++states[k].particles, states[k].mass += m[i];
    }
    if (stay.size() == x.size()) return std::nullopt;
    return stay;
}

template <int Dim>
void OpenFlow<Dim>::emit(Positions<Dim>& x, Velocities<Dim>& v, Masses& m, Density& rho,
                         EmitterStates& states) const {
    for (std::size_t k = 0; k < emitters.size(); ++k) {
        const Emitter<Dim>& e = emitters[k];
        EmitterState& state = states[k];
        const Points<Dim> layer = layer_of(e);
        // Times are multiples of d/v, with as much room as their rounding needs.
        const auto way = [&] { return e.speed * state.time - state.layers * e.spacing; };
        const auto is_over = [&] { return state.layers * e.spacing > e.speed * e.until; };
        for (; way() >= -1e-9 * e.spacing && !is_over(); ++state.layers) {
            const double ahead = std::max(0.0, way());
            const auto others = near_inlet(e, x, ahead + e.spacing);
            for (const Vec<Dim>& place : layer) {
                const Vec<Dim> at = e.centre + place + ahead * e.direction;
                bool is_free = true;
                for (const Vec<Dim>& other : others)
                    is_free = is_free && (other - at).norm() > 0.5 * e.spacing;
                if (!is_free) {
                    ++state.blocked;
                    continue;
                }
                x.push_back(at), v.push_back(e.speed * e.direction);
                m.push_back(e.mass), rho.push_back(e.density);
                ++state.particles, state.mass += e.mass;
            }
        }
    }
}

template Points<2> layer_of<2>(const Emitter<2>&);
template Points<3> layer_of<3>(const Emitter<3>&);
template struct OpenFlow<2>;
template struct OpenFlow<3>;

}  // namespace plumbline
