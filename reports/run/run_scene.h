#pragma once

#include "solver/scene/scene_file.h"

namespace reports {

struct RunOptions {
    std::string folder;
    std::size_t steps = 0;   // stop after so many; 0: at the end
    bool go_on = false;      // with the run that is in the folder
    bool overwrite = false;  // a run that is in the folder
    std::string json = {};   // where the manifest is written to once more, - for stdout
};

/// Simulates the scene into a RunFolder. What stops the run, Ctrl-C, a full disk, a particle that leaves the domain,
/// leaves files that can be read, and a checkpoint from which it goes on bit for bit.
/// Throws InvalidInput if the folder holds a run and neither is asked for; Interrupted; SimulationFailed;
/// std::runtime_error if a file cannot be written.
void run_scene(const plumbline::SceneFile& scene, const RunOptions& options);

}  // namespace reports
