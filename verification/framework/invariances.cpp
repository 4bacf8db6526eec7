#include "verification/framework/invariances.h"

#include "solver/foundation/random.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>

namespace verification {

namespace {
using plumbline::Index, plumbline::Mat, plumbline::Vec;

template <int Dim> Mat<Dim> any_rotation() {
    Mat<Dim> R = Mat<Dim>::Identity();
    if (Dim == 1 && uniform(-1.0, 1.0) < 0.0) R = -R;  // the line has no rotation but a reflection
    for (int a = 0; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b) {
            const double angle = uniform(0.0, 2.0 * std::numbers::pi);
            Mat<Dim> turn = Mat<Dim>::Identity();
            turn(a, a) = turn(b, b) = std::cos(angle);
            turn(a, b) = -(turn(b, a) = std::sin(angle));
            R = turn * R;
        }
    return R;
}

/// The lists of the same samples stored in another order.
plumbline::NeighbourLists reordered(const plumbline::NeighbourLists& old,
                                    const std::vector<Index>& order) {
    std::vector<Index> new_of(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) new_of[order[i]] = static_cast<Index>(i);
    plumbline::NeighbourLists lists{{0}, {}};
    for (const Index k : order) {
        for (const Index j : old.of(k)) lists.indices.push_back(new_of[j]);
        std::sort(lists.indices.begin() + static_cast<std::ptrdiff_t>(lists.offsets.back()),
                  lists.indices.end());
        lists.offsets.push_back(lists.indices.size());
    }
    return lists;
}

template <int Dim> double turned(const Similarity<Dim>&, double value) { return value; }
template <int Dim> Vec<Dim> turned(const Similarity<Dim>& by, const Vec<Dim>& v) {
    return by.R * v;
}
double size_of(double value) { return std::abs(value); }
template <int Dim> double size_of(const Vec<Dim>& v) { return v.norm(); }

template <int Dim, class Value>
double change(double support, int power,
              const std::function<Value(const Fields<Dim>&, Index)>& op) {
    const Fields<Dim> here(support);
    const Value value = op(here, here.patch.centre);
    return worst_error(
        [&] {
            const auto by = any_similarity<Dim>(here.size());
            const Fields<Dim> there = here.moved(by);
            const Value expected = turned<Dim>(by, value);
            const Value found = op(there, there.patch.centre);
            const Value difference = std::pow(by.scale, power) * found - expected;
            return size_of(difference) * std::pow(support, power);
        },
        {.number = 40});
}
}  // namespace

template <int Dim> Similarity<Dim> any_similarity(std::size_t n) {
    Similarity<Dim> s{any_rotation<Dim>(), point<Dim>(-10.0, 10.0), std::exp2(uniform(-3.0, 3.0)),
                      std::vector<Index>(n)};
    std::iota(s.order.begin(), s.order.end(), Index{0});
    plumbline::Random random(static_cast<std::uint64_t>(uniform(0.0, 1e9)));
    for (std::size_t i = n; i > 1; --i) std::swap(s.order[i - 1], s.order[random.bits() % i]);
    return s;
}

template <int Dim>
Fields<Dim>::Fields(double support, PatchShape shape) : Disordered<Dim>(support, shape) {
    plumbline::Random random(shape.seed + 2);
    for (std::size_t i = 0; i < this->size(); ++i) {
        f.push_back(random.uniform(-1.0, 1.0));
        u.push_back(Vec<Dim>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); }));
    }
}

template <int Dim> Fields<Dim> Fields<Dim>::moved(const Similarity<Dim>& by) const {
    Fields other = *this;
    const double volume = std::pow(by.scale, Dim);
    other.w = UnderTest<plumbline::Poly6<Dim>>(by.scale * this->w.support());
    for (std::size_t i = 0; i < this->size(); ++i) {
        const Index k = by.order[i];
        other.patch.x[i] = by.scale * (by.R * this->patch.x[k]) + by.t;
        other.patch.V[i] = volume * this->patch.V[k];
        other.m[i] = this->m[k];
        other.rho[i] = this->rho[k] / volume;
        other.f[i] = f[k];
        other.u[i] = by.R * u[k];
        if (k == this->patch.centre) other.patch.centre = static_cast<Index>(i);
    }
    other.patch.neighbours = reordered(this->patch.neighbours, by.order);
    return other;
}

template <int Dim>
double order_under_refinement(double support, double jitter,
                              const std::function<double(const Fields<Dim>&)>& error) {
    const Fields<Dim> coarse(support, {.support = 0, .jitter = jitter});
    Similarity<Dim> halving{Mat<Dim>::Identity(), Vec<Dim>::Zero(), 0.5,
                            std::vector<Index>(coarse.size())};
    std::iota(halving.order.begin(), halving.order.end(), Index{0});
    return std::log2(error(coarse) / error(coarse.moved(halving)));
}

template <int Dim>
double change_under_similarity(double support, int power,
                               const std::function<double(const Fields<Dim>&, Index)>& op) {
    return change<Dim, double>(support, power, op);
}
template <int Dim>
double change_under_similarity(double support, int power,
                               const std::function<Vec<Dim>(const Fields<Dim>&, Index)>& op) {
    return change<Dim, Vec<Dim>>(support, power, op);
}

template <int Dim> const Fields<Dim>& disordered() {
    static const Fields<Dim> fields(2.5);
    return fields;
}

template const Fields<1>& disordered<1>();
template const Fields<2>& disordered<2>();
template const Fields<3>& disordered<3>();
template Similarity<1> any_similarity<1>(std::size_t);
template struct Fields<1>;
template double order_under_refinement<1>(double, double,
                                          const std::function<double(const Fields<1>&)>&);
template double change_under_similarity<1>(double, int,
                                           const std::function<double(const Fields<1>&, Index)>&);
template double change_under_similarity<1>(double, int,
                                           const std::function<Vec<1>(const Fields<1>&, Index)>&);
template Similarity<2> any_similarity<2>(std::size_t);
template struct Fields<2>;
template double order_under_refinement<2>(double, double,
                                          const std::function<double(const Fields<2>&)>&);
template double change_under_similarity<2>(double, int,
                                           const std::function<double(const Fields<2>&, Index)>&);
template double change_under_similarity<2>(double, int,
                                           const std::function<Vec<2>(const Fields<2>&, Index)>&);
template Similarity<3> any_similarity<3>(std::size_t);
template struct Fields<3>;
template double order_under_refinement<3>(double, double,
                                          const std::function<double(const Fields<3>&)>&);
template double change_under_similarity<3>(double, int,
                                           const std::function<double(const Fields<3>&, Index)>&);
template double change_under_similarity<3>(double, int,
                                           const std::function<Vec<3>(const Fields<3>&, Index)>&);

}  // namespace verification
