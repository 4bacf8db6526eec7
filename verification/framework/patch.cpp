#include "verification/framework/patch.h"

#include "solver/foundation/random.h"
#include "solver/neighbours/brute_force.h"

namespace verification {

namespace {
template <int Dim>
bool is_cut_away(const plumbline::Vec<Dim>& p, int free_faces, double tolerance) {
    for (int d = Dim - free_faces; d < Dim; ++d)
        if (p[d] < -tolerance) return true;
    return false;
}

template <int Dim>
void next(Eigen::Matrix<int, Dim, 1>& k, const Eigen::Matrix<int, Dim, 1>& last) {
    for (int d = 0; d < Dim; ++d) {
        if (++k[d] <= last[d] || d == Dim - 1) return;
        k[d] = -last[d];
    }
}
}  // namespace

template <int Dim> Patch<Dim>::Patch(const Lattice<Dim>& lattice, const PatchShape& shape) {
    using Vec = plumbline::Vec<Dim>;
    const double spacing = lattice.basis.col(0).norm(), radius = shape.reach * shape.support;
    // |kᵢ| = |(B⁻¹ x)ᵢ| ≤ ‖row i of B⁻¹‖ ‖x‖
    const Vec limits = lattice.basis.inverse().rowwise().norm() * (radius * (1.0 + 1e-12));
    const Eigen::Matrix<int, Dim, 1> last = limits.array().floor().template cast<int>();
    plumbline::Random random(shape.seed);
    for (Eigen::Matrix<int, Dim, 1> k = -last; k[Dim - 1] <= last[Dim - 1]; next<Dim>(k, last)) {
        Vec p = lattice.basis * k.template cast<double>();
        if (p.norm() > radius * (1.0 + 1e-12)) continue;
        if (is_cut_away<Dim>(p, shape.free_faces, 1e-12 * spacing)) continue;
        if (k.isZero()) centre = static_cast<plumbline::Index>(x.size());
        for (int d = 0; d < Dim; ++d) p[d] += shape.jitter * spacing * random.uniform(-1.0, 1.0);
        x.push_back(p);
    }
    V.assign(x.size(), lattice.cell_volume());
    plumbline::BruteForce<Dim> search;
    search.build(x, shape.support);
    neighbours = search.query(x);
}

template <int Dim>
double worst_between_samples(const Patch<Dim>& patch, double support, int n_places,
                             const std::function<double(const plumbline::Place<Dim>&)>& error,
                             std::uint64_t seed) {
    plumbline::Random random(seed);
    plumbline::BruteForce<Dim> search;
    search.build(patch.x, support);
    double worst = 0.0;
    for (int k = 0; k < n_places; ++k) {
        const plumbline::Points<Dim> x{
            plumbline::Vec<Dim>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); })};
        const auto neighbours = search.query(x);
        worst = std::max(worst, std::abs(error({x[0], neighbours.of(0)})));
    }
    return worst;
}

template struct Patch<1>;
template double worst_between_samples(const Patch<1>&, double, int,
                                      const std::function<double(const plumbline::Place<1>&)>&,
                                      std::uint64_t);
template struct Patch<2>;
template double worst_between_samples(const Patch<2>&, double, int,
                                      const std::function<double(const plumbline::Place<2>&)>&,
                                      std::uint64_t);
template struct Patch<3>;
template double worst_between_samples(const Patch<3>&, double, int,
                                      const std::function<double(const plumbline::Place<3>&)>&,
                                      std::uint64_t);

}  // namespace verification
