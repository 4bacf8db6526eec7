#include "reports/pieces.h"

#include "reports/files.h"
#include "reports/read_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {
std::filesystem::path file_of(const std::filesystem::path& directory, const std::string& key) {
    std::string name = key;
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '/';
    };
    std::ranges::replace_if(
        name, [&](char c) { return !plain(static_cast<unsigned char>(c)); }, '_');
    return directory / (name + ".json");
}

/// Changes with every build that changes the program, which git describe does not before a commit.
std::string identity_of_program() {
    const std::filesystem::path program = "/proc/self/exe";
    std::error_code missing;
    const auto size = std::filesystem::file_size(program, missing);
    const auto time = std::filesystem::last_write_time(program, missing);
    return missing ? "" : fmt::format("{}.{}", size, time.time_since_epoch().count());
}
}  // namespace

Pieces::Pieces(std::filesystem::path directory, std::string fingerprint)
    : directory_{std::move(directory)}, fingerprint_{std::move(fingerprint)} {}

Json Pieces::get(const std::string& key, const std::function<Json()>& make) {
    if (directory_.empty()) return make();
    const std::filesystem::path file = file_of(directory_, key);
    if (std::filesystem::exists(file)) {
        const Json kept = parse_json(read_file(file));
        if (kept.is_object() && kept.value("fingerprint", "") == fingerprint_ &&
            kept.value("key", "") == key && kept.contains("result")) {
            ++reused_;
            return kept["result"];
        }
    }
    Json result = make();
    std::filesystem::create_directories(file.parent_path());
    write_file(file, lines({{"key", key}, {"fingerprint", fingerprint_}, {"result", result}}));
    return result;
}

std::string fingerprint(const std::string& options) {
    const Provenance p = provenance();
    return fmt::format("{}; {}; {}; {} threads; {}", p.version, identity_of_program(), p.processor,
                       p.threads, options);
}

}  // namespace reports
