#pragma once

#include "reports/json.h"

#include <filesystem>
#include <string>

namespace reports {

/// Where a run stands: what the program knows (`progress`), and the state of the simulation.
struct Checkpoint {
    Json progress;
    std::string state;
};

/// One line that names the kind of file, one of JSON, and the bytes of the state. Written as a whole or not at all.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);
/// Throws InvalidInput if the file cannot be read, is of another kind, cut short or damaged.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace reports
