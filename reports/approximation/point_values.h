#pragma once

#include "solver/io/read_points.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reports {

enum class Family { sph, shepard, mls, mlsph, mueller };

/// A method of approximation that is chosen at run time.
struct Method {
    Family family;
    int order = 0;  // of mls and mlsph
};

/// A method, and what it is.
struct NamedMethod {
    std::string name;
    Method method;
    std::string source, says;
};
/// "sph", "shepard", "mls:N", "mlsph:N" and "mueller", N = 0..3.
const std::vector<NamedMethod>& methods();

/// The one of that name. Throws InvalidInput if there is none.
Method parse_method(std::string_view text);

/// A field and its derivatives at one point; what the method does not give there is empty.
struct PointValue {
    std::optional<double> value;
    std::vector<double> gradient;  // dim numbers, or none
    std::optional<double> laplacian;
    /// `ok`, or why the numbers are missing or less than the method promises:
    ///  - `no_neighbours`: no sample is closer than the support;
    ///  - `rank_deficient:k`: the samples tell only k of the basis polynomials apart; exact on those;
    ///  - `reduced_order:n`: mlsph had to use order n; no Laplacian if n < 2;
    ///  - `not_a_sample`: mueller gives gradients at samples only;
    ///  - `repeated_sample`: mueller at samples that coincide, with different values;
    ///  - `no_laplacian`: the order in use is below 2 (adams2009 Eq. 34; shepard is of order 0), or the
    ///    kernel has a kink there, at a sample;
    ///  - `no_gradient`: shepard at a sample, whose value it takes with a singular kernel;
    ///  - `not_finite`: the weights or the numbers overflow, or the kernel is singular there.
    std::string status;
};

struct ApproximationTask {
    const plumbline::PointFile& samples;
    const plumbline::PointFile& at;
    std::string field;                // column of the samples
    std::optional<std::string> mass;  // likewise; all masses are 1 without it
    Method method;
    std::string kernel;
    double support;
};

/// The field at every point of `at`. sph and shepard take Vⱼ = mⱼ/ρⱼ with ρ by adams2009 Eq. 5;
/// with a kernel that is infinite at 0 there is no ρ, and shepard takes Vⱼ = 1.
/// Throws InvalidInput if dimensions differ, a column or the kernel does not exist, the support is not
/// positive and finite, or (sph, shepard) a mass is not positive, or (sph) the kernel is infinite at 0.
std::vector<PointValue> approximate(const ApproximationTask& task);

}  // namespace reports
