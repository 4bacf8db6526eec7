#pragma once

#include "reports/json.h"

#include <filesystem>

namespace reports {

/// The result in `file`. Throws InvalidInput, with the place of the error, if it is not JSON.
Json read_json(const std::filesystem::path& file);

}  // namespace reports
