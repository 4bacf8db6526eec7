#pragma once

#include "verification/framework/claim.h"

#include <string>
#include <vector>

namespace verification {

/// The claim that `make<d>()` makes, for each d of `Dims`; the ids get "_1d", "_2d", "_3d".
/// `Register{in_dimensions<2, 3>([]<int Dim>() { return Claim{…}; })}`.
template <int... Dims, class Make> std::vector<Claim> in_dimensions(Make make) {
    std::vector<Claim> claims{make.template operator()<Dims>()...};
    const std::vector<int> dims{Dims...};
    for (std::size_t k = 0; k < claims.size(); ++k)
        claims[k].id.append("_").append(std::to_string(dims[k])).append("d");
    return claims;
}

}  // namespace verification
