#pragma once

#include "reports/json.h"

#include <filesystem>

namespace reports {

/// The result in `file`. Throws InvalidInput, with the place of the error, if it is not JSON.
Json read_json(const std::filesystem::path& file);

/// The JSON in `text`; its is_discarded() tells where there is none.
Json parse_json(std::string_view text);

}  // namespace reports
