#include "verification/framework/approximation_study.h"
#include "verification/framework/registry.h"

namespace verification {

namespace {
constexpr Sampling samplings[] = {Sampling::lattice, Sampling::jittered, Sampling::halton};
constexpr Region regions[] = {Region::interior, Region::boundary};

/// Eq. 11 needs a support that grows faster: at h ~ spacing^(1/2) its noise keeps pace with h².
double support_exponent(Quantity quantity) {
    return quantity == Quantity::laplacian ? 1.0 / 3.0 : 0.5;
}

void add_fixed(Quantity quantity, std::vector<Study>& studies) {
    for (const Sampling sampling : samplings)
        for (const Region region : regions)
            for (const int dim : {1, 2, 3})
                if (dim > 1 || sampling != Sampling::halton)
                    studies.push_back(study_of({quantity, {dim, sampling, region}}));
    for (const Region region : regions)
        studies.push_back(study_of(
            {quantity,
             {.dim = 2, .sampling = Sampling::jittered, .region = region, .norm = Norm::max}}));
}

/// On a lattice, what the sums miss of a derivative goes up and down with h/spacing, as a Bessel function:
/// no power law. Values rest on it only after smoothing has gone.
void add_growing(Quantity quantity, std::vector<Study>& studies) {
    const double exponent = support_exponent(quantity);
    const auto add = [&](int dim, Sampling sampling, Region region) {
        studies.push_back(study_of({quantity, {dim, sampling, region, exponent}}));
    };
    for (const int dim : {2, 3}) add(dim, Sampling::jittered, Region::interior);
    add(2, Sampling::halton, Region::interior);
    if (quantity == Quantity::value) add(2, Sampling::lattice, Region::interior);
    if (quantity != Quantity::laplacian) add(2, Sampling::jittered, Region::boundary);
}

std::vector<Study> all_studies() {
    std::vector<Study> studies;
    for (const Quantity quantity : {Quantity::value, Quantity::gradient, Quantity::laplacian}) {
        add_fixed(quantity, studies);
        add_growing(quantity, studies);
    }
    for (const Quantity quantity : {Quantity::value, Quantity::gradient})
        studies.push_back(study_of({quantity, {2, Sampling::jittered, Region::interior}, true}));
    return studies;
}

const Register convergence_studies{all_studies()};
}  // namespace

}  // namespace verification
