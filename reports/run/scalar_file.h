#pragma once

#include "solver/scene/scalars.h"

#include <filesystem>

namespace reports {

/// scalars.csv: a row for each time of interest. After a failure to write, the file ends with its last whole row.
class ScalarFile {
public:
    /// Begins the file, or goes on behind its first `keep` bytes. Throws InvalidInput if it has fewer.
    ScalarFile(std::filesystem::path file, const plumbline::SceneFile& scene, std::size_t keep);

    /// `dt` [s] and `why` of the step that led here. Throws std::runtime_error if the row cannot be written.
    void add(double time, std::size_t step, double dt, std::string_view why,
             const plumbline::SceneFile& scene, const plumbline::Snapshot& particles);
    std::size_t bytes() const { return bytes_; }

private:
    void append(const std::string& text);

    std::filesystem::path file_;
    std::size_t bytes_ = 0;
};

}  // namespace reports
