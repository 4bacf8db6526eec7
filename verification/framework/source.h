#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace verification {

/// adams2009 and wicke2006 are the two texts that Plumbline verifies; literature is any other
/// publication, named in `place`; plumbline is a promise of our own, made in a docstring or the README.
enum class Paper { adams2009, wicke2006, literature, plumbline };

std::string_view name_of(Paper paper);

/// Where a formula or a claim is printed: {Paper::adams2009, "Eqs. 9, 13"}, {…, "Alg. 4; Sec. 5.2"}.
struct Source {
    Paper paper;
    std::string_view place;
};

/// The single items that `place` names: "Eqs. 86-88, 92; Alg. 4" gives
/// {"Eq. 86", "Eq. 87", "Eq. 88", "Eq. 92", "Alg. 4"}. Text in another form gives itself.
std::vector<std::string> items_of(std::string_view place);

}  // namespace verification
