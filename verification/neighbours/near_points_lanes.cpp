#include "solver/neighbours/near_points_lanes.h"

#include "verification/framework/registry.h"
#include "verification/neighbours/near_tests.h"

namespace near_points_lanes_claims {
namespace {
using namespace plumbline;
using namespace verification;
using Bits = NearFunctions<double>::Bits;

struct Found {
    std::vector<Index> selected, taken;
    std::vector<Bits> bits;
    std::size_t marked = 0;
    bool operator==(const Found&) const = default;
};
template <class Real> Found find(const NearFunctions<Real>& near, const NearTest<Real>& test) {
    Found found;
    found.selected.resize(test.size + candidates_per_step);
    found.taken.resize(test.size + candidates_per_step);
    found.bits.resize((test.size + candidates_per_step - 1) / candidates_per_step);
    found.selected.resize(near.select(test, found.selected.data()));
    found.marked = near.mark(test, found.bits.data());
    found.taken.resize(near.take(test, found.bits.data(), found.taken.data()));
    return found;
}

/// What is kept of the candidates: ids and coordinates.
template <class Real, int Dim, class Space>
std::pair<std::vector<Index>, std::vector<Real>> kept(Instructions instructions, const Space& space,
                                                      NearCase<Real, Dim> drawn) {
    const auto functions = near_functions<Real>(instructions, Dim, Space::is_periodic);
    const VecOf<Real, Dim> corner = VecOf<Real, Dim>::Constant(Real(0.1));
    auto& all = drawn.candidates;
    all.keep_near(functions, space, drawn.centre - corner, drawn.centre + corner,
                  drawn.squared_radius);
    std::vector<Real> x;
    for (int axis = 0; axis < Dim; ++axis) x.insert(x.end(), all.x(axis), all.x(axis) + all.size());
    return {{all.id(), all.id() + all.size()}, x};
}

/// Sets of 0 .. 99 candidates of which the vector form finds others than the plain form.
template <class Real, int Dim, class Space>
double differences(const Space& space, Instructions instructions, Real radius_factor) {
    const auto plain = near_functions<Real>(Instructions::plain, Dim, Space::is_periodic);
    const auto vector = near_functions<Real>(instructions, Dim, Space::is_periodic);
    double different = 0.0;
    for (std::size_t n = 0; n < 100; ++n) {
        NearCase<Real, Dim> drawn(n);
        const Found expected = find(plain, drawn.test(space, 0));
        const Found later = find(plain, drawn.test(space, n / 3));
        const auto expected_near_box = kept(Instructions::plain, space, drawn);
        drawn.squared_radius *= radius_factor;
        different += kept(instructions, space, drawn) != expected_near_box;
        const Found found = find(vector, drawn.test(space, 0));
        different += found != expected || found.selected != found.taken ||
                     found.selected.size() != found.marked;
        different += find(vector, drawn.test(space, n / 3)).selected != later.selected;
    }
    return different;
}
template <class Real, int Dim> double in_both_spaces(Instructions instructions, Real factor) {
    const PeriodicBox<Dim> box(Vec<Dim>::Constant(-0.8), Vec<Dim>::Constant(0.8));
    return differences<Real, Dim>(OpenSpace<Dim>{}, instructions, factor) +
           differences<Real, Dim>(box, instructions, factor);
}
/// Of all instruction sets up to the best that this processor has. `wider` in units of rounding.
double differences_from_plain(int wider) {
    const double factor = 1.0 + wider * 0x1p-50;
    const float float_factor = 1.0f + static_cast<float>(wider) * 0x1p-21f;
    double different = 0.0;
    for (const auto set : {Instructions::plain, Instructions::avx2, Instructions::avx512}) {
        if (set > best_instructions()) continue;
        different += in_both_spaces<double, 1>(set, factor) +
                     in_both_spaces<double, 2>(set, factor) +
                     in_both_spaces<double, 3>(set, factor);
        different += in_both_spaces<float, 1>(set, float_factor) +
                     in_both_spaces<float, 2>(set, float_factor) +
                     in_both_spaces<float, 3>(set, float_factor);
    }
    return different;
}

/// Sets of candidates of which the test in single precision finds others than the one in double. Points are
/// multiples of 0.1, so that many are at the radius, up to `offset` away from the origin. A mistake to be
/// caught: no margin for rounding.
double differences_from_double(double offset, bool without_margin) {
    const OpenSpace<3> space;
    double different = 0.0;
    for (const auto set : {Instructions::avx2, Instructions::avx512}) {
        if (set > best_instructions()) continue;
        const auto near = near_functions<double>(set, 3, false);
        for (std::size_t n = 0; n < 100; ++n) {
            NearCase<double, 3> drawn(n);
            drawn.centre.array() += offset;
            for (int axis = 0; axis < 3; ++axis)
                for (std::size_t k = 0; k < n; ++k) drawn.candidates.x(axis)[k] += offset;
            const Found expected = find(near, drawn.test(space, 0));
            const Found later = find(near, drawn.test(space, n / 3));
            const Vec<3> corner(0.3, 0.0, 0.1);
            drawn.candidates.round(drawn.centre - corner, drawn.centre + 2.0 * corner);
            const auto rounded = [&](std::size_t from) {
                NearTest<double> test = drawn.test(space, from);
                if (without_margin)
                    test.rounded.near = test.rounded.perhaps =
                        static_cast<float>(test.squared_radius);
                return test;
            };
            different += rounded(0).rounded.x[0] == nullptr;
            different += find(near, rounded(0)) != expected;
            different += find(near, rounded(n / 3)) != later;
        }
    }
    return different;
}

const Register claims_of_near_points_lanes{
    Claim{.id = "near_points.single_precision_decides_as_double",
          .source = {Paper::plumbline, "docstring of RoundedTest"},
          .says =
              "tests in single precision give the candidates of double precision, with many at the "
              "radius, at the origin and 1e3 and 1e8 away from it",
          .bound = at_most(0.0, "what single precision cannot tell, double precision decides"),
          .measure =
              [] {
                  return differences_from_double(0.0, false) + differences_from_double(1e3, false) +
                         differences_from_double(1e8, false);
              },
          .sabotaged = [] { return differences_from_double(0.0, true); }},
    Claim{.id = "near_points.vector_instructions_equal_the_plain_form",
          .source = {Paper::plumbline, "docstring of Instructions"},
          .says = "AVX2 and AVX-512 select, mark, take and keep the candidates of the plain form, "
                  "in single "
                  "and double precision, 1D, 2D and 3D, open space and periodic box",
          .bound = at_most(0.0, "the same operations in the same order, without contraction"),
          .measure = [] { return differences_from_plain(0); },
          .sabotaged = [] { return differences_from_plain(1); }},
};
}  // namespace
}  // namespace near_points_lanes_claims
