#include "solver/neighbours/near_points_lanes.h"

#if defined(__AVX2__)

#include <immintrin.h>

namespace plumbline {
namespace {

/// For each of the 256 sets of 8 lanes: which lane each place of the packed result takes.
struct LanesOfSets {
    alignas(32) std::uint32_t lanes[256][8] = {};
    constexpr LanesOfSets() {
        for (std::uint32_t set = 0; set < 256; ++set)
            for (std::uint32_t lane = 0, place = 0; lane < 8; ++lane)
                if (set >> lane & 1u) lanes[set][place++] = lane;
    }
};
constexpr LanesOfSets lanes_of_sets;

void store_ids(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
    for (unsigned lane = 0; lane < candidates_per_step; lane += 8) {
        const unsigned set = bits >> lane & 255u;
        const auto* order = reinterpret_cast<const __m256i*>(lanes_of_sets.lanes[set]);
        const auto* from = reinterpret_cast<const __m256i*>(ids + lane);
        _mm256_storeu_si256(
            reinterpret_cast<__m256i*>(out),
            _mm256_permutevar8x32_epi32(_mm256_loadu_si256(from), _mm256_load_si256(order)));
        out += __builtin_popcount(set);
    }
}

struct DoubleLanes {
    using Real = double;
    using Vector = __m256d;
    static constexpr std::size_t size = 4;
    static Vector all(double x) { return _mm256_set1_pd(x); }
    static Vector load(const double* p) { return _mm256_loadu_pd(p); }
    static Vector subtract(Vector a, Vector b) { return _mm256_sub_pd(a, b); }
    static Vector add(Vector a, Vector b) { return _mm256_add_pd(a, b); }
    static Vector multiply(Vector a, Vector b) { return _mm256_mul_pd(a, b); }
    static Vector into_box(Vector d, Vector edge, Vector half, Vector minus_half) {
        const Vector above = _mm256_and_pd(_mm256_cmp_pd(d, half, _CMP_GT_OQ), edge);
        const Vector below_half = _mm256_and_pd(_mm256_cmp_pd(d, minus_half, _CMP_LT_OQ), edge);
        return add(subtract(d, above), below_half);
    }
    static unsigned below(Vector a, Vector b) {
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
    }
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        store_ids(ids, bits, out);
    }
};

struct FloatLanes {
    using Real = float;
    using Vector = __m256;
    static constexpr std::size_t size = 8;
    static Vector all(float x) { return _mm256_set1_ps(x); }
    static Vector load(const float* p) { return _mm256_loadu_ps(p); }
    static Vector subtract(Vector a, Vector b) { return _mm256_sub_ps(a, b); }
    static Vector add(Vector a, Vector b) { return _mm256_add_ps(a, b); }
    static Vector multiply(Vector a, Vector b) { return _mm256_mul_ps(a, b); }
    static Vector into_box(Vector d, Vector edge, Vector half, Vector minus_half) {
        const Vector above = _mm256_and_ps(_mm256_cmp_ps(d, half, _CMP_GT_OQ), edge);
        const Vector below_half = _mm256_and_ps(_mm256_cmp_ps(d, minus_half, _CMP_LT_OQ), edge);
        return add(subtract(d, above), below_half);
    }
    static unsigned below(Vector a, Vector b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
    }
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        store_ids(ids, bits, out);
    }
};
}  // namespace

NearFunctions<double> near_functions_avx2(double, int dim, bool periodic) {
    return near_functions_of<DoubleLanes>(dim, periodic);
}
NearFunctions<float> near_functions_avx2(float, int dim, bool periodic) {
    return near_functions_of<FloatLanes>(dim, periodic);
}
}  // namespace plumbline

#endif
