#pragma once

#include "solver/foundation/types.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace plumbline {

/// f(0), …, f(N − 1) with constants for arguments: what a loop over an array leaves in memory, between two
/// lines of arithmetic, stays in registers.
template <int N, class F> [[gnu::always_inline]] inline void for_each_constant(F f) {
    [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
        (f(std::integral_constant<int, k>()), ...);
    }
    (std::make_integer_sequence<int, N>());
}

/// Several numbers that are computed with at once, by one instruction where the processor has one: with
/// AVX 8 in single precision and 4 in double, with AVX-512 8 in double too, else half as many. Every operation is rounded as that of
/// scalars is.
template <class Real> struct Lanes {
#if defined(__AVX512F__)
    static constexpr std::size_t bytes = 8 * sizeof(Real);  // 16 floats were no faster
#elif defined(__AVX__)
    static constexpr std::size_t bytes = 32;
#else
    static constexpr std::size_t bytes = 16;
#endif
    static constexpr std::size_t size = bytes / sizeof(Real);
    typedef Real Vector __attribute__((vector_size(bytes)));
    Vector v;

    Lanes() = default;
    explicit Lanes(Vector vector) : v{vector} {}
    Lanes(double all) : v{static_cast<Real>(all) - Vector{}} {}  // implicit: lanes times numbers

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
    friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
    Lanes& operator+=(Lanes b) { return *this = *this + b; }
    Lanes& operator-=(Lanes b) { return *this = *this - b; }

    friend Lanes min(Lanes a, Lanes b) { return Lanes(a.v < b.v ? a.v : b.v); }
    friend Lanes max(Lanes a, Lanes b) { return Lanes(a.v > b.v ? a.v : b.v); }
    friend Lanes sqrt(Lanes a) {
#if defined(__AVX__)
        if constexpr (sizeof(Real) == 4) return Lanes(_mm256_sqrt_ps(a.v));
#endif
#if defined(__AVX512F__)
        if constexpr (sizeof(Real) == 8) return Lanes(_mm512_sqrt_pd(a.v));
#elif defined(__AVX__)
        if constexpr (sizeof(Real) == 8) return Lanes(_mm256_sqrt_pd(a.v));
#endif
        for (std::size_t k = 0; k < size; ++k) a.v[k] = std::sqrt(a.v[k]);
        return a;
    }
    /// d, or where it is beyond ± edge/2 its nearest image in a box that repeats: see PeriodicBox.
    friend Lanes nearest_image(Lanes d, Lanes edge) {
        const Lanes half = 0.5 * edge;
        return Lanes(d.v > half.v ? d.v - edge.v : d.v < -half.v ? d.v + edge.v : d.v);
    }
    /// `size` numbers that lie one behind the other.
    static Lanes load(const Real* from) {
        Lanes lanes;
        std::memcpy(&lanes.v, from, sizeof lanes.v);
        return lanes;
    }
    /// Lane k is from[places[k]].
    static Lanes gather(const Real* from, const Index* places) {
        Lanes lanes;
        for (std::size_t k = 0; k < size; ++k) lanes.v[k] = from[places[k]];
        return lanes;
    }
    /// Of all lanes, added in one order: halves, quarters, and so on.
    friend double sum(Lanes a) {
        std::array<Real, size> all;
        std::memcpy(all.data(), &a.v, sizeof a.v);
        return static_cast<double>(sum_of_halves<size>(all));
    }

private:
    template <std::size_t N> static Real sum_of_halves(const std::array<Real, N>& all) {
        if constexpr (N == 1)
            return all[0];
        else {
            std::array<Real, N / 2> half;
            for_each_constant<static_cast<int>(N / 2)>(
                [&](auto k) { half[k] = all[k] + all[k + N / 2]; });
            return sum_of_halves(half);
        }
    }
};

/// A vector of each lane.
template <class Real, int Dim> struct LaneVector {
    Lanes<Real> x[Dim];

    static LaneVector zero() {
        LaneVector a;
        for_each_constant<Dim>([&](auto d) { a.x[d] = 0.0; });
        return a;
    }
    friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
        LaneVector c;
        for_each_constant<Dim>([&](auto d) { c.x[d] = a.x[d] + b.x[d]; });
        return c;
    }
    friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
        LaneVector c;
        for_each_constant<Dim>([&](auto d) { c.x[d] = a.x[d] - b.x[d]; });
        return c;
    }
    friend LaneVector operator*(Lanes<Real> s, const LaneVector& a) {
        LaneVector c;
        for_each_constant<Dim>([&](auto d) { c.x[d] = s * a.x[d]; });
        return c;
    }
    LaneVector& operator+=(const LaneVector& b) { return *this = *this + b; }
    LaneVector& operator-=(const LaneVector& b) { return *this = *this - b; }
    friend Lanes<Real> dot(const LaneVector& a, const LaneVector& b) {
        Lanes<Real> total = a.x[0] * b.x[0];
        for_each_constant<Dim - 1>([&](auto d) { total += a.x[d + 1] * b.x[d + 1]; });
        return total;
    }
    friend Vec<Dim> sum(const LaneVector& a) {
        Vec<Dim> total;
        for (int d = 0; d < Dim; ++d) total[d] = sum(a.x[d]);
        return total;
    }
};

/// Four numbers of each of as many records as there are lanes: lane k of out[f] is
/// from[rows[k] · stride + f].
template <class Real>
[[gnu::always_inline]] inline void gather_four(const Real* from, std::size_t stride,
                                               const Index* rows, Lanes<Real>* out) {
    for (std::size_t k = 0; k < Lanes<Real>::size; ++k)
        for (std::size_t f = 0; f < 4; ++f) out[f].v[k] = from[rows[k] * stride + f];
}

// The same by whole records and shuffles, several times faster than by single numbers.
#if defined(__AVX__)
[[gnu::always_inline]] inline void gather_four(const float* from, std::size_t stride,
                                               const Index* rows, Lanes<float>* out) {
    const auto two = [&](std::size_t k) __attribute__((always_inline)) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(from + rows[k] * stride)),
                                    _mm_loadu_ps(from + rows[k + 4] * stride), 1);
    };
    const __m256 a = two(0), b = two(1), c = two(2), d = two(3);
    const __m256 ab_low = _mm256_unpacklo_ps(a, b), ab_high = _mm256_unpackhi_ps(a, b);
    const __m256 cd_low = _mm256_unpacklo_ps(c, d), cd_high = _mm256_unpackhi_ps(c, d);
    out[0].v = _mm256_shuffle_ps(ab_low, cd_low, 0x44);
    out[1].v = _mm256_shuffle_ps(ab_low, cd_low, 0xee);
    out[2].v = _mm256_shuffle_ps(ab_high, cd_high, 0x44);
    out[3].v = _mm256_shuffle_ps(ab_high, cd_high, 0xee);
}
#endif
#if defined(__AVX512F__)
[[gnu::always_inline]] inline void gather_four(const double* from, std::size_t stride,
                                               const Index* rows, Lanes<double>* out) {
    const auto two = [&](std::size_t k) __attribute__((always_inline)) {
        const auto one = [&](std::size_t row) __attribute__((always_inline)) {
            return _mm256_loadu_pd(from + rows[row] * stride);
        };
        return _mm512_insertf64x4(_mm512_castpd256_pd512(one(k)), one(k + 4), 1);
    };
    const __m512d a = two(0), b = two(1), c = two(2), d = two(3);
    const __m512d ab_even = _mm512_unpacklo_pd(a, b), ab_odd = _mm512_unpackhi_pd(a, b);
    const __m512d cd_even = _mm512_unpacklo_pd(c, d), cd_odd = _mm512_unpackhi_pd(c, d);
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    out[0].v = _mm512_permutex2var_pd(ab_even, first, cd_even);
    out[1].v = _mm512_permutex2var_pd(ab_odd, first, cd_odd);
    out[2].v = _mm512_permutex2var_pd(ab_even, second, cd_even);
    out[3].v = _mm512_permutex2var_pd(ab_odd, second, cd_odd);
}
#elif defined(__AVX__)
[[gnu::always_inline]] inline void gather_four(const double* from, std::size_t stride,
                                               const Index* rows, Lanes<double>* out) {
    const auto one = [&](std::size_t k) __attribute__((always_inline)) {
        return _mm256_loadu_pd(from + rows[k] * stride);
    };
    const __m256d a = one(0), b = one(1), c = one(2), d = one(3);
    const __m256d ab_even = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
    const __m256d cd_even = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
    out[0].v = _mm256_permute2f128_pd(ab_even, cd_even, 0x20);
    out[1].v = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20);
    out[2].v = _mm256_permute2f128_pd(ab_even, cd_even, 0x31);
    out[3].v = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31);
}
#endif

}  // namespace plumbline
