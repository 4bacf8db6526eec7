#include "solver/particles/morton_order.h"

#include "verification/framework/property.h"
#include "verification/framework/registry.h"

#include <rapidcheck.h>

#include <bitset>

namespace morton_order_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> GridCell<Dim> any_cell() {
    GridCell<Dim> cell;
    for (auto& c : cell) c = *rc::gen::inRange<std::uint32_t>(0, 1u << curve_bits<Dim>);
    return cell;
}

/// The coordinate along `axis` read back from the bits of a place, by counting positions in the text
/// of the binary number.
template <int Dim>
std::uint32_t read_back(std::uint64_t place, std::size_t axis, std::size_t first_axis) {
    const std::string bits = std::bitset<64>(place).to_string().substr(
        64 - Dim * static_cast<std::size_t>(curve_bits<Dim>));
    std::string mine;
    for (std::size_t k = (axis + first_axis) % Dim; k < bits.size(); k += Dim) mine += bits[k];
    return static_cast<std::uint32_t>(std::stoul(mine, nullptr, 2));
}

template <int Dim> double places_misread(std::size_t first_axis) {
    return counterexamples([=] {
        const auto cell = any_cell<Dim>();
        for (std::size_t d = 0; d < Dim; ++d)
            RC_ASSERT(read_back<Dim>(morton_place<Dim>(cell), d, first_axis) == cell[d]);
    });
}

const Register claims_of_morton{
    Claim{.id = "morton_order.interleaves_bits_2d",
          .source = {Paper::literature, "Morton 1966"},
          .says = "every other bit of a cell's place spells x, the others y",
          .bound = at_most(0, "no counterexample: integers, no rounding"),
          .measure = [] { return places_misread<2>(0); },
          .sabotaged = [] { return places_misread<2>(1); }},
    Claim{.id = "morton_order.interleaves_bits_3d",
          .source = {Paper::literature, "Morton 1966"},
          .says = "every third bit of a cell's place spells x, the next y, the next z",
          .bound = at_most(0, "no counterexample: integers, no rounding"),
          .measure = [] { return places_misread<3>(0); },
          .sabotaged = [] { return places_misread<3>(1); }},
};
}  // namespace
}  // namespace morton_order_claims
