#include "reports/scenes.h"

#include "solver/foundation/errors.h"
#include "solver/scene/scene_file.h"

#include <algorithm>

namespace reports {

std::vector<ExampleScene> example_scenes() {
    std::vector<ExampleScene> all;
    std::error_code none;  // an installed program without its source tree has no examples
    for (const auto& entry : std::filesystem::directory_iterator(PLUMBLINE_SCENES, none))
        if (entry.path().extension() == ".toml")
            all.push_back({entry.path().stem().string(),
                           plumbline::SceneFile::read(entry.path()).title, entry.path()});
    std::ranges::sort(all, {}, &ExampleScene::name);
    return all;
}

std::filesystem::path scene_path(const std::string& scene) {
    if (std::filesystem::exists(scene)) return scene;
    const std::filesystem::path example =
        std::filesystem::path(PLUMBLINE_SCENES) / (scene + ".toml");
    if (scene.find('/') == std::string::npos && std::filesystem::exists(example)) return example;
    throw plumbline::InvalidInput(
        scene +
        ": expected a scene file, or the name of an example (see plumbline list scenes), "
        "found neither");
}

}  // namespace reports
