#include "solver/neighbours/near_points_lanes.h"

#if defined(__AVX512F__) && defined(__AVX512VL__)

#include <immintrin.h>

namespace plumbline {
namespace {

void store_ids(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
    const __m512i all = _mm512_loadu_si512(ids);
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), all));
}

struct DoubleLanes {
    using Real = double;
    using Vector = __m512d;
    static constexpr std::size_t size = 8;
    static Vector all(double x) { return _mm512_set1_pd(x); }
    static Vector load(const double* p) { return _mm512_loadu_pd(p); }
    static Vector subtract(Vector a, Vector b) { return _mm512_sub_pd(a, b); }
    static Vector add(Vector a, Vector b) { return _mm512_add_pd(a, b); }
    static Vector multiply(Vector a, Vector b) { return _mm512_mul_pd(a, b); }
    static Vector into_box(Vector d, Vector edge, Vector half, Vector minus_half) {
        const __mmask8 above = _mm512_cmp_pd_mask(d, half, _CMP_GT_OQ);
        const __mmask8 below_half = _mm512_cmp_pd_mask(d, minus_half, _CMP_LT_OQ);
        return _mm512_mask_add_pd(_mm512_mask_sub_pd(d, above, d, edge), below_half, d, edge);
    }
    static unsigned below(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        store_ids(ids, bits, out);
    }
};

struct FloatLanes {
    using Real = float;
    using Vector = __m512;
    static constexpr std::size_t size = 16;
    static Vector all(float x) { return _mm512_set1_ps(x); }
    static Vector load(const float* p) { return _mm512_loadu_ps(p); }
    static Vector subtract(Vector a, Vector b) { return _mm512_sub_ps(a, b); }
    static Vector add(Vector a, Vector b) { return _mm512_add_ps(a, b); }
    static Vector multiply(Vector a, Vector b) { return _mm512_mul_ps(a, b); }
    static Vector into_box(Vector d, Vector edge, Vector half, Vector minus_half) {
        const __mmask16 above = _mm512_cmp_ps_mask(d, half, _CMP_GT_OQ);
        const __mmask16 below_half = _mm512_cmp_ps_mask(d, minus_half, _CMP_LT_OQ);
        return _mm512_mask_add_ps(_mm512_mask_sub_ps(d, above, d, edge), below_half, d, edge);
    }
    static unsigned below(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        store_ids(ids, bits, out);
    }
};
}  // namespace

NearFunctions<double> near_functions_avx512(double, int dim, bool periodic) {
    return near_functions_of<DoubleLanes>(dim, periodic);
}
NearFunctions<float> near_functions_avx512(float, int dim, bool periodic) {
    return near_functions_of<FloatLanes>(dim, periodic);
}
}  // namespace plumbline

#endif
