#include "reports/commands/checks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace reports {

CLI::Validator positive_number() {
    return {[](const std::string& text) -> std::string {
                char* end = nullptr;
                const double value = std::strtod(text.c_str(), &end);
                const bool number = !text.empty() && *end == '\0';
                if (number && value > 0.0 && std::isfinite(value)) return {};
                return fmt::format("expected a positive number, found \"{}\"", text);
            },
            "POSITIVE"};
}

CLI::Validator output_file() {
    return {[](const std::string& text) -> std::string {
                namespace fs = std::filesystem;
                if (text == "-") return {};
                const fs::path path(text), folder = fs::absolute(path).parent_path();
                std::error_code no;
                const bool exists = fs::exists(path, no);
                const char* why = nullptr;
                if (!fs::is_directory(folder, no))
                    why = "its folder does not exist";
                else if (text.empty() || fs::is_directory(path, no))
                    why = "that is a folder";
                else if (access(exists ? path.c_str() : folder.c_str(), W_OK) != 0)
                    why = "permission denied";
                if (!why) return {};
                return fmt::format("expected a file to write, found \"{}\": {}", text, why);
            },
            "FILE"};
}

}  // namespace reports
