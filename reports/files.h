#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace reports {

/// Writes all of `text`, or nothing: an interrupted run leaves no half file behind.
/// Throws std::runtime_error if that fails.
void write_file(const std::filesystem::path& file, std::string_view text);

/// The whole file. Throws InvalidInput if it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace reports
