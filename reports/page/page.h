#pragma once

#include "reports/json.h"

#include <filesystem>
#include <string>

namespace reports {

/// The page of a report: one HTML file with everything in it, which needs neither a network nor a
/// script. Draws the charts into `charts`; a function of the report alone.
std::string page_of(const Json& report, const std::filesystem::path& charts);

}  // namespace reports
