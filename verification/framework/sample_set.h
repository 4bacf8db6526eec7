#pragma once

#include "solver/approximation/samples.h"
#include "verification/framework/any_kernel.h"

#include <cstdint>
#include <string_view>

namespace verification {

enum class Sampling { lattice, jittered, halton };
enum class Region { interior, boundary };
/// Where errors are measured: some methods exist at samples only; a value is also wanted elsewhere, and
/// on a lattice symmetry flatters what is measured at its points.
enum class MeasuredAt { samples, between };
/// The kernels of the studies: the one of adams2009 Appendix A, and two that are smoother.
enum class StudyKernel { poly6, wendland_c4, quintic_spline };

std::string_view name_of(Sampling sampling);
std::string_view name_of(Region region);
std::string_view name_of(StudyKernel kernel);

template <int Dim> AnyKernel<Dim> kernel_of(StudyKernel kernel, double support);

/// How far each coordinate of a jittered lattice is moved at most, in spacings.
inline constexpr double study_jitter = 0.25;

struct SampleSetup {
    Sampling sampling;
    Region region;
    double spacing;  // [m]; of Halton points (volume / number)^(1/Dim)
    double support;  // [m]
    std::uint64_t seed;
    MeasuredAt measured_at = MeasuredAt::samples;
    StudyKernel kernel = StudyKernel::poly6;
    auto operator<=>(const SampleSetup&) const = default;  // NOLINT(modernize-use-nullptr): its 0
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

/// The places where errors are measured, and all samples within one support of them, with equal masses,
/// densities by adams2009 Eq. 5 and volumes by Eq. 4.
template <int Dim> struct SampleSet {
    AnyKernel<Dim> kernel;
    plumbline::Points<Dim> places;
    plumbline::Points<Dim> x;
    std::vector<double> m, rho, V;
    std::vector<plumbline::Index> measured;  // the places as samples; empty if they are none
    plumbline::NeighbourLists rows;          // of the places
    plumbline::NeighbourLists neighbours;    // of the measured samples; others have empty rows

    explicit SampleSet(const SampleSetup& setup);
    plumbline::Samples<Dim> samples() const { return {x, V, neighbours}; }
    plumbline::Place<Dim> place(std::size_t k) const {
        return {places[k], rows.of(static_cast<plumbline::Index>(k))};
    }
};

}  // namespace verification
