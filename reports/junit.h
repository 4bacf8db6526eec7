#pragma once

#include "verification/framework/claim.h"

#include <string>
#include <vector>

namespace reports {

/// The results as a JUnit test suite: one test case for each claim.
std::string junit_of(const std::vector<verification::ClaimResult>& results);

}  // namespace reports
