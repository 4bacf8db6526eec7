#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reports {

/// A scene file that comes with Plumbline.
struct ExampleScene {
    std::string name, title;
    std::filesystem::path file;
};

/// Those in reports/scenes, by name.
std::vector<ExampleScene> example_scenes();
/// `scene` if there is such a file, else the example of that name. Throws InvalidInput if it is neither.
std::filesystem::path scene_path(const std::string& scene);

}  // namespace reports
