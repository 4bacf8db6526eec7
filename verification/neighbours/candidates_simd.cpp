#include "solver/neighbours/candidates_simd.h"

#include "solver/foundation/random.h"
#include "verification/framework/registry.h"

namespace {
using namespace plumbline;
using namespace verification;

/// Differences between the bits, counts and ids of two instruction sets, over 300 sets of candidates
/// with many ties at the radius.
template <int Dim> double differences(Instructions one, Instructions other, double radius_factor) {
    Random random(31);
    double different = 0.0;
    for (std::size_t n = 0; n < 300; ++n) {
        Candidates<Dim> near;
        near.resize(n);
        Vec<Dim> q;
        for (int a = 0; a < Dim; ++a) {
            q[a] = std::round(random.uniform(-4, 4)) * 0.1;
            for (std::size_t k = 0; k < n; ++k)
                near.x(a)[k] = std::round(random.uniform(-8, 8)) * 0.1;
        }
        for (std::size_t k = 0; k < n; ++k) near.id()[k] = static_cast<Index>(random.bits());
        near.close();
        const double limit = 0.5 * 0.5;
        std::vector<std::uint64_t> a(near.words()), b(near.words());
        const OpenSpace<Dim> space;
        const auto found_a = test_candidates(one, space, q, limit, near, a.data());
        const auto found_b =
            test_candidates(other, space, q, limit * radius_factor, near, b.data());
        std::vector<Index> ids_a(n + 64), ids_b(n + 64);
        const auto selected_a =
            select_candidates(one, near.id(), near.words(), a.data(), ids_a.data());
        const auto selected_b =
            select_candidates(other, near.id(), near.words(), b.data(), ids_b.data());
        ids_a.resize(selected_a);
        ids_b.resize(selected_b);
        different += a != b || found_a != found_b || found_a != selected_a || ids_a != ids_b;
    }
    return different;
}

/// Against the plain form, of all instruction sets up to the best that this processor has.
double differences_from_plain(double radius_factor) {
    double different = 0.0;
    for (const auto instructions : {Instructions::avx2, Instructions::avx512})
        if (instructions <= best_instructions())
            different += differences<1>(Instructions::plain, instructions, radius_factor) +
                         differences<2>(Instructions::plain, instructions, radius_factor) +
                         differences<3>(Instructions::plain, instructions, radius_factor);
    if (best_instructions() == Instructions::plain && radius_factor != 1.0)
        different = differences<3>(Instructions::plain, Instructions::plain, radius_factor);
    return different;
}

const Register claims_of_candidates_simd{
    Claim{.id = "candidates.vector_instructions_equal_the_plain_form",
          .source = {Paper::plumbline, "docstring of Instructions"},
          .says =
              "AVX2 and AVX-512 give the bits, counts and ids of the plain form, in 1D, 2D and 3D",
          .bound = at_most(0.0, "the same operations in the same order, without contraction"),
          .measure = [] { return differences_from_plain(1.0); },
          .sabotaged = [] { return differences_from_plain(1.0 + 0x1p-50); }},
};
}  // namespace
