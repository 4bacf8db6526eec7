#include "solver/neighbours/near_points.h"

#include <algorithm>

namespace plumbline {

#if defined(__x86_64__)
NearFunctions<double> near_functions_avx2(double, int dim, bool periodic);
NearFunctions<float> near_functions_avx2(float, int dim, bool periodic);
NearFunctions<double> near_functions_avx512(double, int dim, bool periodic);
NearFunctions<float> near_functions_avx512(float, int dim, bool periodic);
#endif

Instructions best_instructions() {
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

namespace {

/// The plain form that the vector forms (near_points_lanes.h) are compared with.
template <class Real, int Dim, bool Periodic>
bool is_near(const NearTest<Real>& test, std::size_t k) {
    Real squared = 0;
    for (int axis = 0; axis < Dim; ++axis) {
        Real d = test.centre[axis] - test.x[axis][k];
        const Real edge = test.edge[axis], half = Real(0.5) * edge;
        if (Periodic) d = d > half ? d - edge : d < -half ? d + edge : d;
        squared += d * d;
    }
    return squared < test.squared_radius;
}
template <class Real, int Dim, bool Periodic>
std::size_t select_plainly(const NearTest<Real>& test, std::uint32_t* out) {
    std::size_t found = 0;
    for (std::size_t k = test.from; k < test.size; ++k) {
        out[found] = test.id[k];
        found += is_near<Real, Dim, Periodic>(test, k) ? 1 : 0;
    }
    return found;
}
template <class Real, int Dim, bool Periodic>
std::size_t mark_plainly(const NearTest<Real>& test, std::uint16_t* bits) {
    constexpr std::size_t step = candidates_per_step;
    if (bits != nullptr) std::fill_n(bits, (test.size + step - 1) / step, 0);
    std::size_t found = 0;
    for (std::size_t k = test.from; k < test.size; ++k) {
        const unsigned bit = is_near<Real, Dim, Periodic>(test, k) ? 1 : 0;
        if (bits != nullptr)
            bits[k / step] = static_cast<std::uint16_t>(bits[k / step] | bit << k % step);
        found += bit;
    }
    return found;
}
template <class Real>
std::size_t take_plainly(const NearTest<Real>& test, const std::uint16_t* bits,
                         std::uint32_t* out) {
    constexpr std::size_t step = candidates_per_step;
    std::size_t found = 0;
    for (std::size_t k = 0; k < test.size; ++k)
        if (bits[k / step] >> k % step & 1u) out[found++] = test.id[k];
    return found;
}
template <class Real, int Dim, bool Periodic> std::size_t keep_plainly(const BoxTest<Real>& test) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < test.size; ++k) {
        Real squared = 0;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real below = test.low[axis] - test.x[axis][k];
            const Real above = test.x[axis][k] - test.high[axis];
            Real gap = std::max({below, above, Real(0)});
            if (Periodic)
                gap = std::min(gap, std::max(test.edge[axis] + std::min(below, above), Real(0)));
            squared += gap * gap;
        }
        if (!(squared < test.squared_radius)) continue;
        for (int axis = 0; axis < Dim; ++axis) test.x[axis][kept] = test.x[axis][k];
        test.id[kept++] = test.id[k];
    }
    return kept;
}
template <class Real, int Dim, bool Periodic> NearFunctions<Real> plain_functions() {
    return {select_plainly<Real, Dim, Periodic>, mark_plainly<Real, Dim, Periodic>,
            take_plainly<Real>, keep_plainly<Real, Dim, Periodic>};
}
template <class Real, int Dim> NearFunctions<Real> plain_functions(bool periodic) {
    return periodic ? plain_functions<Real, Dim, true>() : plain_functions<Real, Dim, false>();
}
}  // namespace

template <class Real>
NearFunctions<Real> near_functions(Instructions instructions, int dim, bool periodic) {
#if defined(__x86_64__)
    if (instructions == Instructions::avx512) return near_functions_avx512(Real(), dim, periodic);
    if (instructions == Instructions::avx2) return near_functions_avx2(Real(), dim, periodic);
#endif
    if (dim == 1) return plain_functions<Real, 1>(periodic);
    if (dim == 2) return plain_functions<Real, 2>(periodic);
    return plain_functions<Real, 3>(periodic);
}
template NearFunctions<double> near_functions<double>(Instructions, int, bool);
template NearFunctions<float> near_functions<float>(Instructions, int, bool);

}  // namespace plumbline
