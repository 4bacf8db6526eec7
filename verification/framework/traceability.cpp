#include "verification/framework/traceability.h"

#include <algorithm>

namespace verification {

const std::vector<Statement>& statements() {
    using enum Paper;
    static const std::vector<Statement> all{
        {adams2009, "Eq. 1", "f as a convolution with the Dirac delta"},
        {adams2009, "Eq. 2", "f smoothed by a kernel"},
        {adams2009, "Eq. 3", "SPH approximation of a function"},
        {adams2009, "Eq. 4", "volume of a sample"},
        {adams2009, "Eq. 5", "SPH density"},
        {adams2009, "Eq. 6", "mass as a function concentrated at the samples"},
        {adams2009, "Eq. 7", "density as the smoothed mass"},
        {adams2009, "Eq. 8", "normalisation of a kernel"},
        {adams2009, "Eq. 9", "SPH gradient"},
        {adams2009, "Eq. 10", "gradient of a kernel"},
        {adams2009, "Eq. 11", "SPH Laplacian"},
        {adams2009, "Eq. 12", "SPH divergence"},
        {adams2009, "Eq. 13", "gradient, zero for constants"},
        {adams2009, "Eq. 14", "divergence, zero for constants"},
        {adams2009, "Eq. 15", "Laplacian, zero for constants"},
        {adams2009, "Eq. 16", "product rule for the gradient of ρ f"},
        {adams2009, "Eq. 17", "gradient from the product rule"},
        {adams2009, "Eq. 18", "quotient rule for the gradient of f / ρ"},
        {adams2009, "Eq. 19", "symmetric gradient"},
        {adams2009, "Eq. 20", "the Laplacian is not the divergence of the gradient"},
        {adams2009, "Eq. 21", "weighted squared error of a local fit"},
        {adams2009, "Eq. 22", "its normal equations"},
        {adams2009, "Eq. 23", "coefficients of the fit"},
        {adams2009, "Eq. 24", "moment matrix"},
        {adams2009, "Eq. 25", "MLS approximation"},
        {adams2009, "Eq. 26", "MLS approximation by shape functions"},
        {adams2009, "Eq. 27", "MLS shape function"},
        {adams2009, "Sec. 3.2", "consistency up to the order of the basis"},
        {adams2009, "Sec. 3.3", "singular moment matrices and safe inversion"},
        {adams2009, "Eq. 28", "moment matrix, centred"},
        {adams2009, "Eq. 29", "MLS shape function, centred"},
        {adams2009, "Eq. 30", "derivative of an MLS shape function"},
        {adams2009, "Eq. 31", "derivative of the inverse moment matrix"},
        {adams2009, "Eq. 32", "MLS gradient"},
        {adams2009, "Eq. 33", "MLS divergence"},
        {adams2009, "Eq. 34", "MLS Laplacian"},
        {adams2009, "Eq. 35", "Taylor expansion around a particle"},
        {adams2009, "Eq. 36", "its first-order approximation"},
        {adams2009, "Eq. 37", "least-squares gradient at a particle"},
        {adams2009, "Eq. 38", "its moment matrix"},
        {adams2009, "Eq. 39", "both methods as sums of shape functions"},
        {adams2009, "Eq. 40", "SPH shape function"},
        {adams2009, "Eq. 41", "MLS shape function"},
        {adams2009, "Table 1", "SPH and MLS side by side"},
        {adams2009, "Eq. 42", "cell of a point"},
        {adams2009, "Eq. 43", "hash of a cell"},
        {adams2009, "Alg. 1", "construction of a kd-tree"},
        {adams2009, "Alg. 2", "query of a kd-tree"},
        {adams2009, "Alg. 3", "construction of a hash grid"},
        {adams2009, "Alg. 4", "query of a hash grid"},
        {adams2009, "Sec. 5.3", "comparison of kd-tree and hash grid"},
        {adams2009, "Eq. 44", "momentum of a fluid"},
        {adams2009, "Eq. 45", "pressure force"},
        {adams2009, "Eq. 46", "viscosity force"},
        {adams2009, "Eq. 47", "Tait equation"},
        {adams2009, "Eq. 48", "momentum of a particle"},
        {adams2009, "Eq. 49", "acceleration by pressure"},
        {adams2009, "Eq. 50", "by the plain gradient"},
        {adams2009, "Eq. 51", "by the symmetric gradient"},
        {adams2009, "Eq. 52", "acceleration by viscosity"},
        {adams2009, "Eq. 53", "artificial viscosity: XSPH"},
        {adams2009, "Eq. 54", "scaling of negative pressures"},
        {adams2009, "Eq. 55", "density with ghosts"},
        {adams2009, "Eq. 56", "viscosity with ghosts"},
        {adams2009, "Eq. 57", "artificial viscosity with ghosts"},
        {adams2009, "Eq. 58", "step of the velocity"},
        {adams2009, "Eq. 59", "step of the position"},
        {adams2009, "Alg. 5", "simulation of a fluid"},
        {adams2009, "Eq. 86", "poly6 kernel in space"},
        {adams2009, "Eq. 87", "its first derivative"},
        {adams2009, "Eq. 88", "its second derivative"},
        {adams2009, "Eq. 89", "poly6 kernel in the plane"},
        {adams2009, "Eq. 90", "its first derivative"},
        {adams2009, "Eq. 91", "its second derivative"},
        {adams2009, "Eq. 92", "spiky kernel in space"},
        {adams2009, "Eq. 93", "its first derivative"},
        {adams2009, "Eq. 94", "its second derivative"},
        {adams2009, "Eq. 95", "spiky kernel in the plane"},
        {adams2009, "Eq. 96", "its first derivative"},
        {adams2009, "Eq. 97", "its second derivative"},
    };
    return all;
}

std::vector<const Claim*> claims_of(const Statement& statement) {
    std::vector<const Claim*> named;
    for (const Claim& claim : claims()) {
        if (claim.source.paper != statement.paper) continue;
        if (std::ranges::count(items_of(claim.source.place), statement.item) > 0)
            named.push_back(&claim);
    }
    return named;
}

}  // namespace verification
