#pragma once

#include "verification/framework/registry.h"

#include <string>
#include <string_view>
#include <vector>

namespace verification {

/// One thing that a text states and that must be verified: an equation, an algorithm, a table.
struct Statement {
    Paper paper;
    std::string_view item;  // as items_of() names it: "Eq. 13", "Alg. 4"
    std::string_view says;
};

/// All statements of the parts that this version covers: adams2009 Sections 2-5 and Appendix A.
const std::vector<Statement>& statements();

/// The claims whose source names the statement.
std::vector<const Claim*> claims_of(const Statement& statement);

}  // namespace verification
