#pragma once

#include "solver/neighbours/candidates.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace plumbline {

/// The instructions that test_candidates and select_candidates are written for here, next to their
/// plain forms in candidates.h; all give the same bits.
enum class Instructions { plain, avx2, avx512 };

/// The best that this processor has, found at run time.
inline Instructions best_instructions() {
#if defined(__x86_64__)
    static const Instructions best = [] {
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
            return Instructions::avx512;
        return __builtin_cpu_supports("avx2") ? Instructions::avx2 : Instructions::plain;
    }();
    return best;
#else
    return Instructions::plain;
#endif
}

#if defined(__x86_64__)

template <int Dim>
__attribute__((target("avx512f,avx512vl,popcnt"))) std::size_t test_candidates_avx512(
    const Vec<Dim>& q, double squared_radius, const Candidates<Dim>& c, std::uint64_t* within) {
    __m512d centre[Dim];
    for (int axis = 0; axis < Dim; ++axis) centre[axis] = _mm512_set1_pd(q[axis]);
    const __m512d limit = _mm512_set1_pd(squared_radius);
    std::size_t found = 0;
    for (std::size_t w = 0; w < c.words(); ++w) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < 64 && w * 64 + k < c.size(); k += 8) {
            __m512d d = _mm512_sub_pd(centre[0], _mm512_loadu_pd(c.x(0) + w * 64 + k));
            __m512d squared = _mm512_mul_pd(d, d);
            for (int axis = 1; axis < Dim; ++axis) {
                d = _mm512_sub_pd(centre[axis], _mm512_loadu_pd(c.x(axis) + w * 64 + k));
                squared = _mm512_add_pd(squared, _mm512_mul_pd(d, d));
            }
            const __mmask8 closer = _mm512_cmp_pd_mask(squared, limit, _CMP_LT_OQ);
            bits |= static_cast<std::uint64_t>(closer) << k;
        }
        within[w] = bits;
        found += static_cast<std::size_t>(__builtin_popcountll(bits));
    }
    return found;
}

__attribute__((target("avx512f,avx512vl,popcnt"))) inline std::size_t select_candidates_avx512(
    const Index* id, std::size_t words, const std::uint64_t* within, Index* out) {
    std::size_t found = 0;
    for (std::size_t w = 0; w < words; ++w)
        for (std::size_t k = 0; k < 64; k += 16) {
            const auto bits = static_cast<__mmask16>(within[w] >> k);
            const __m512i ids = _mm512_loadu_si512(id + w * 64 + k);
            _mm512_storeu_si512(out + found, _mm512_maskz_compress_epi32(bits, ids));
            found += static_cast<std::size_t>(__builtin_popcount(bits));
        }
    return found;
}

template <int Dim>
__attribute__((target("avx2,popcnt"))) std::size_t test_candidates_avx2(const Vec<Dim>& q,
                                                                        double squared_radius,
                                                                        const Candidates<Dim>& c,
                                                                        std::uint64_t* within) {
    __m256d centre[Dim];
    for (int axis = 0; axis < Dim; ++axis) centre[axis] = _mm256_set1_pd(q[axis]);
    const __m256d limit = _mm256_set1_pd(squared_radius);
    std::size_t found = 0;
    for (std::size_t w = 0; w < c.words(); ++w) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < 64 && w * 64 + k < c.size(); k += 4) {
            __m256d d = _mm256_sub_pd(centre[0], _mm256_loadu_pd(c.x(0) + w * 64 + k));
            __m256d squared = _mm256_mul_pd(d, d);
            for (int axis = 1; axis < Dim; ++axis) {
                d = _mm256_sub_pd(centre[axis], _mm256_loadu_pd(c.x(axis) + w * 64 + k));
                squared = _mm256_add_pd(squared, _mm256_mul_pd(d, d));
            }
            const int closer = _mm256_movemask_pd(_mm256_cmp_pd(squared, limit, _CMP_LT_OQ));
            bits |= static_cast<std::uint64_t>(closer) << k;
        }
        within[w] = bits;
        found += static_cast<std::size_t>(__builtin_popcountll(bits));
    }
    return found;
}

/// For each of the 256 sets of 8 lanes: which lane each place of the packed result takes.
inline const std::array<std::array<Index, 8>, 256>& lanes_of_sets() {
    static const auto table = [] {
        std::array<std::array<Index, 8>, 256> lanes{};
        for (Index set = 0; set < 256; ++set)
            for (Index lane = 0, place = 0; lane < 8; ++lane)
                if (set >> lane & 1u) lanes[set][place++] = lane;
        return lanes;
    }();
    return table;
}

__attribute__((target("avx2,popcnt"))) inline std::size_t select_candidates_avx2(
    const Index* id, std::size_t words, const std::uint64_t* within, Index* out) {
    const auto& lanes = lanes_of_sets();
    std::size_t found = 0;
    for (std::size_t w = 0; w < words; ++w)
        for (std::size_t k = 0; k < 64; k += 8) {
            const auto set = static_cast<unsigned>(within[w] >> k) & 255u;
            const auto* from = reinterpret_cast<const __m256i*>(id + w * 64 + k);
            const auto* order = reinterpret_cast<const __m256i*>(lanes[set].data());
            const __m256i packed =
                _mm256_permutevar8x32_epi32(_mm256_loadu_si256(from), _mm256_loadu_si256(order));
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + found), packed);
            found += static_cast<std::size_t>(__builtin_popcount(set));
        }
    return found;
}

#endif

/// test_candidates by the given instructions, which the processor must have.
template <int Dim>
std::size_t test_candidates(Instructions instructions, const OpenSpace<Dim>& space,
                            const Vec<Dim>& q, double squared_radius, const Candidates<Dim>& c,
                            std::uint64_t* within) {
#if defined(__x86_64__)
    if (instructions == Instructions::avx512)
        return test_candidates_avx512(q, squared_radius, c, within);
    if (instructions == Instructions::avx2)
        return test_candidates_avx2(q, squared_radius, c, within);
#endif
    return test_candidates(space, q, squared_radius, c, within);
}
template <int Dim>
std::size_t test_candidates(Instructions, const PeriodicBox<Dim>& box, const Vec<Dim>& q,
                            double squared_radius, const Candidates<Dim>& c,
                            std::uint64_t* within) {
    return test_candidates(box, q, squared_radius, c, within);
}

inline std::size_t select_candidates(Instructions instructions, const Index* id, std::size_t words,
                                     const std::uint64_t* within, Index* out) {
#if defined(__x86_64__)
    if (instructions == Instructions::avx512)
        return select_candidates_avx512(id, words, within, out);
    if (instructions == Instructions::avx2) return select_candidates_avx2(id, words, within, out);
#endif
    return select_candidates(id, words, within, out);
}

}  // namespace plumbline
