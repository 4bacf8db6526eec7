#pragma once

#include "solver/approximation/samples.h"
#include "solver/kernels/poly6.h"

#include <cstdint>
#include <string_view>

namespace verification {

enum class Sampling { lattice, jittered, halton };
enum class Region { interior, boundary };

std::string_view name_of(Sampling sampling);
std::string_view name_of(Region region);

/// The kernel of the studies: the one of adams2009 Appendix A.
template <int Dim> using StudyKernel = plumbline::Poly6<Dim>;

/// How far each coordinate of a jittered lattice is moved at most, in spacings.
inline constexpr double study_jitter = 0.25;

struct SampleSetup {
    Sampling sampling;
    Region region;
    double spacing;  // [m]; of Halton points (volume / number)^(1/Dim)
    double support;  // [m]
    std::uint64_t seed;
    auto operator<=>(const SampleSetup&) const = default;
};

/// Samples of one study at one level, and those of them at which errors are measured.
/// - interior: those in the unit box, which the samples overlap by two supports all around, one for
///   the sum itself and one for the densities in it: no boundary is felt, and the same region is
///   measured on all levels;
/// - boundary: those less than one support from the boundary of the unit box, which the samples fill.
/// At most `most_measured` of them are, chosen at random, in ascending order.
template <int Dim> struct SamplePoints {
    plumbline::Points<Dim> x;
    std::vector<plumbline::Index> measured;

    SamplePoints(const SampleSetup& setup, std::size_t most_measured);
};

/// The same with equal masses, densities by adams2009 Eq. 5, volumes by Eq. 4, for `StudyKernel`.
template <int Dim> struct SampleSet {
    static constexpr std::size_t most_measured = Dim == 2 ? 2000 : 800;

    StudyKernel<Dim> kernel;
    plumbline::Points<Dim> x;
    std::vector<plumbline::Index> measured;
    std::vector<double> m, rho, V;
    plumbline::NeighbourLists neighbours;

    explicit SampleSet(const SampleSetup& setup);
    plumbline::Samples<Dim> samples() const { return {x, V, neighbours}; }

private:
    SampleSet(const SampleSetup& setup, SamplePoints<Dim> points);
};

}  // namespace verification
