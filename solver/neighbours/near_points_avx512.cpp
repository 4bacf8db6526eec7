#include "solver/neighbours/near_points_lanes.h"

#if defined(__AVX512F__) && defined(__AVX512VL__)

#include <immintrin.h>

namespace plumbline {
namespace {

/// Lanes of any 16 numbers of 32 bits.
struct Ids {
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        const __m512i all = _mm512_loadu_si512(ids);
        _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), all));
    }
};

struct FloatLanes : VectorOf<float, 64>, Ids {
    static Vector larger(Vector a, Vector b) { return _mm512_max_ps(a, b); }
    static unsigned below(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
    static void pack(Vector v, unsigned bits, float* out) {
        _mm512_storeu_ps(out, _mm512_maskz_compress_ps(static_cast<__mmask16>(bits), v));
    }
};
struct DoubleLanes : VectorOf<double, 64>, Ids {
    using Rounded = FloatLanes;
    static Vector larger(Vector a, Vector b) { return _mm512_max_pd(a, b); }
    static unsigned below(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
    static void pack(Vector v, unsigned bits, double* out) {
        _mm512_storeu_pd(out, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), v));
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
