#pragma once

#include "solver/foundation/types.h"

#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace plumbline {

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
    Lanes(double all) : v{} {  // implicit: lanes are multiplied by numbers
        for (std::size_t k = 0; k < size; ++k) v[k] = static_cast<Real>(all);
    }

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
    /// Of all lanes, added in one order.
    friend double sum(Lanes a) {
        for (std::size_t n = size / 2; n > 0; n /= 2)
            for (std::size_t k = 0; k < n; ++k) a.v[k] += a.v[k + n];
        return static_cast<double>(a.v[0]);
    }
};

/// A vector of each lane.
template <class Real, int Dim> struct LaneVector {
    Lanes<Real> x[Dim];

    static LaneVector zero() {
        LaneVector a;
        for (Lanes<Real>& x_d : a.x) x_d = 0.0;
        return a;
    }
    friend LaneVector operator+(LaneVector a, const LaneVector& b) {
        for (int d = 0; d < Dim; ++d) a.x[d] += b.x[d];
        return a;
    }
    friend LaneVector operator-(LaneVector a, const LaneVector& b) {
        for (int d = 0; d < Dim; ++d) a.x[d] -= b.x[d];
        return a;
    }
    friend LaneVector operator*(Lanes<Real> s, LaneVector a) {
        for (Lanes<Real>& x_d : a.x) x_d = s * x_d;
        return a;
    }
    LaneVector& operator+=(const LaneVector& b) { return *this = *this + b; }
    LaneVector& operator-=(const LaneVector& b) { return *this = *this - b; }
    friend Lanes<Real> dot(const LaneVector& a, const LaneVector& b) {
        Lanes<Real> total = a.x[0] * b.x[0];
        for (int d = 1; d < Dim; ++d) total += a.x[d] * b.x[d];
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
void gather_four(const Real* from, std::size_t stride, const Index* rows, Lanes<Real>* out) {
    for (std::size_t k = 0; k < Lanes<Real>::size; ++k)
        for (std::size_t f = 0; f < 4; ++f) out[f].v[k] = from[rows[k] * stride + f];
}

// The same by whole records and shuffles, several times faster than by single numbers.
#if defined(__AVX__)
inline void gather_four(const float* from, std::size_t stride, const Index* rows,
                        Lanes<float>* out) {
    const auto two = [&](std::size_t k) {
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
inline void gather_four(const double* from, std::size_t stride, const Index* rows,
                        Lanes<double>* out) {
    const auto two = [&](std::size_t k) {
        const auto one = [&](std::size_t row) {
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
inline void gather_four(const double* from, std::size_t stride, const Index* rows,
                        Lanes<double>* out) {
    const auto one = [&](std::size_t k) { return _mm256_loadu_pd(from + rows[k] * stride); };
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
