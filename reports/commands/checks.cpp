#include "reports/commands/checks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace reports {

namespace {
namespace fs = std::filesystem;

bool may_write(const fs::path& path) { return access(path.c_str(), W_OK) == 0; }
}  // namespace

Check positive_number() {
    return {[](const std::string& text) -> std::string {
                char* end = nullptr;
                const double value = std::strtod(text.c_str(), &end);
                const bool number = !text.empty() && *end == '\0';
                if (number && value > 0.0 && std::isfinite(value)) return {};
                return fmt::format("expected a positive number, found \"{}\"", text);
            },
            "POSITIVE"};
}

Check output_file() {
    return {[](const std::string& text) -> std::string {
                std::error_code no;
                const fs::path path(text), folder = fs::absolute(path, no).parent_path();
                const auto refused = [&](const char* why) {
                    return fmt::format("expected a file to write, found \"{}\": {}", text, why);
                };
                if (text == "-") return {};
                if (!fs::is_directory(folder, no)) return refused("its folder does not exist");
                if (text.empty()) return refused("that is no name");
                if (fs::is_directory(path, no)) return refused("that is a folder");
                if (!may_write(fs::exists(path, no) ? path : folder))
                    return refused("permission denied");
                return {};
            },
            "FILE"};
}

Check output_folder() {
    return {[](const std::string& text) -> std::string {
                std::error_code no;
                const auto refused = [&](const char* why) {
                    return fmt::format("expected a folder to write into, found \"{}\": {}", text,
                                       why);
                };
                if (text.empty()) return refused("that is no name");
                fs::path there = fs::absolute(text, no);
                while (!fs::exists(there, no) && there != there.parent_path())
                    there = there.parent_path();
                if (!fs::is_directory(there, no)) return refused("that is a file");
                if (!may_write(there)) return refused("permission denied");
                return {};
            },
            "FOLDER"};
}

}  // namespace reports
