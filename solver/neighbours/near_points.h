#pragma once

#include <cstddef>
#include <cstdint>

namespace plumbline {

/// Instruction sets that the distance test is written for; all give the same lists.
enum class Instructions { plain, avx2, avx512 };

/// The best that this processor has, found at run time.
Instructions best_instructions();

/// Candidates are tested so many at a time.
inline constexpr std::size_t candidates_per_step = 16;

/// The same test in single precision, which is twice as fast, for points in double precision in open space:
/// a candidate is near if its squared distance is below `near`, and is not unless it is below `perhaps`;
/// between the two double precision decides. Not to be used if x[0] is null.
struct RoundedTest {
    const float* x[3];
    float centre[3];
    float near, perhaps;
};

/// Which candidates are near `centre`: the squared distance, by the expression of squared_distance
/// (space.h) in the precision Real, is below `squared_radius`. Plain data, since files compiled for
/// other instruction sets must share no inline function with the rest of the program.
template <class Real> struct NearTest {
    const Real* x[3];         // coordinates of the candidates, axis by axis
    const std::uint32_t* id;  // what is listed for each
    /// Candidates from .. size are tested; arrays are readable up to a whole step, and
    /// coordinates beyond `size` are infinite.
    std::size_t from, size;
    Real centre[3];
    Real squared_radius;
    Real edge[3];  // of the periodic box
    RoundedTest rounded;
};

/// Which candidates are near some point of a box: the squared gap to it, which is rounded like a squared
/// distance and so never exceeds that of a point in the box, is below `squared_radius`.
template <class Real> struct BoxTest {
    Real* x[3];  // of the candidates; arrays as in NearTest
    std::uint32_t* id;
    std::size_t size;
    Real low[3], high[3];
    Real squared_radius;
    Real edge[3];  // of the periodic box
};

/// All return how many candidates are near. `out` needs room for as many as were tested and a step
/// more; ids are written to it in the order of the candidates.
template <class Real> struct NearFunctions {
    using Bits = std::uint16_t;  // one bit for each candidate of a step
    /// Writes the ids of those that are near.
    std::size_t (*select)(const NearTest<Real>& test, std::uint32_t* out);
    /// Writes one word of bits for each step from 0 to size, unless `bits` is null.
    std::size_t (*mark)(const NearTest<Real>& test, Bits* bits);
    /// Writes the ids of those that were marked.
    std::size_t (*take)(const NearTest<Real>& test, const Bits* bits, std::uint32_t* out);
    /// Moves those that are near the box to the front, in their order; all others are lost.
    std::size_t (*keep)(const BoxTest<Real>& test);
};

/// Those for points in 1, 2 or 3 dimensions, in open space or in a periodic box. The processor must
/// have the instructions.
template <class Real>
NearFunctions<Real> near_functions(Instructions instructions, int dim, bool periodic);

}  // namespace plumbline
