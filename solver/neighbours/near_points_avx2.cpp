#include "solver/neighbours/near_points_lanes.h"

#if defined(__AVX2__)

#include <immintrin.h>

namespace plumbline {
namespace {

/// For each set of lanes, of `Parts` numbers of 32 bits each: which number each place of the packed
/// result takes.
template <std::uint32_t Parts> struct PlacesOfSets {
    static constexpr std::uint32_t lanes = 8 / Parts;
    alignas(32) std::uint32_t places[1u << lanes][8] = {};
    constexpr PlacesOfSets() {
        for (std::uint32_t set = 0; set < 1u << lanes; ++set)
            for (std::uint32_t lane = 0, place = 0; lane < lanes; ++lane)
                for (std::uint32_t part = 0; part < Parts && (set >> lane & 1u) != 0; ++part)
                    places[set][place++] = Parts * lane + part;
    }
    __m256i of(unsigned set) const {
        return _mm256_load_si256(reinterpret_cast<const __m256i*>(places[set]));
    }
};
constexpr PlacesOfSets<1> singles;
constexpr PlacesOfSets<2> pairs;

struct Ids {
    static void store(const std::uint32_t* ids, unsigned bits, std::uint32_t* out) {
        for (unsigned lane = 0; lane < candidates_per_step; lane += 8) {
            const unsigned set = bits >> lane & 255u;
            const auto* from = reinterpret_cast<const __m256i*>(ids + lane);
            _mm256_storeu_si256(
                reinterpret_cast<__m256i*>(out),
                _mm256_permutevar8x32_epi32(_mm256_loadu_si256(from), singles.of(set)));
            out += __builtin_popcount(set);
        }
    }
};

struct FloatLanes : VectorOf<float, 32>, Ids {
    static Vector larger(Vector a, Vector b) { return _mm256_max_ps(a, b); }
    static unsigned below(Vector a, Vector b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
    }
    static void pack(Vector v, unsigned bits, float* out) {
        _mm256_storeu_ps(out, _mm256_permutevar8x32_ps(v, singles.of(bits)));
    }
};
struct DoubleLanes : VectorOf<double, 32>, Ids {
    using Rounded = FloatLanes;
    static Vector larger(Vector a, Vector b) { return _mm256_max_pd(a, b); }
    static unsigned below(Vector a, Vector b) {
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
    }
    static void pack(Vector v, unsigned bits, double* out) {
        const __m256 packed = _mm256_permutevar8x32_ps(_mm256_castpd_ps(v), pairs.of(bits));
        _mm256_storeu_pd(out, _mm256_castps_pd(packed));
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
