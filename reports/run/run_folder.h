#pragma once

#include "reports/json.h"
#include "reports/run/scalar_file.h"
#include "solver/io/pvd_series.h"

#include <map>
#include <optional>

namespace reports {

/// Where a run stands, for its checkpoint and its manifest.
struct RunRecord {
    double time = 0.0;
    std::size_t steps = 0;
    std::size_t scalar_rows = 0;         // multiples of the interval that have had their row
    std::vector<double> frames;          // times
    std::map<std::string, int> decided;  // steps by what decided their length
    double smallest_step = HUGE_VAL;     // [s], those cut short by a frame left out
    double seconds = 0.0;                // of computing, over all pieces of the run
    double dt = 0.0;                     // of the last step ...
    std::string why = "start";           // ... and what decided it
};

/// All files of a run. Every file but scalars.csv is written as a whole or not at all, so that whatever stops the
/// run leaves files that can be read.
class RunFolder {
public:
    RunFolder(std::filesystem::path folder, const plumbline::SceneFile& scene)
        : folder_{std::move(folder)}, scene_{scene} {}

    /// Whether a run has begun here.
    bool holds_run() const;
    /// Deletes what a run writes, and nothing else.
    void clear() const;
    /// Begins a new run: the folder, a copy of the scene, the walls, and scalars.csv.
    void begin(const plumbline::Snapshot& particles);
    /// The checkpoint of a run of the same scene, whose state is returned. Throws InvalidInput if there is none, or
    /// if the scene has changed.
    std::string resume(RunRecord& record);

    void add_scalars(const RunRecord& record, const plumbline::Snapshot& particles);
    /// Particles, surface, picture, the series; `record.frames` has the new frame as its last one.
    void add_frame(const RunRecord& record, const plumbline::Snapshot& particles);
    void write_checkpoint(const RunRecord& record, std::string state) const;
    /// Not of the series: the state before a step that failed.
    void write_last_good(const plumbline::Snapshot& particles) const;
    Json write_manifest(const RunRecord& record, const std::string& status,
                        const plumbline::Snapshot& particles) const;
    /// film.mp4 of all pictures, if there is ffmpeg.
    void make_film() const;

    const std::filesystem::path& path() const { return folder_; }

private:
    void write_series(const RunRecord& record, const std::string& name,
                      const std::string& format) const;

    std::filesystem::path folder_;
    const plumbline::SceneFile& scene_;
    std::optional<ScalarFile> scalars_;
};

}  // namespace reports
