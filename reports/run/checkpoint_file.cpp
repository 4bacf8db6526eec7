#include "reports/run/checkpoint_file.h"

#include "reports/files.h"
#include "reports/read_json.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

namespace reports {

namespace {
constexpr std::string_view kind = "plumbline.checkpoint/1\n";

/// FNV-1a: tells a damaged file from a whole one.
std::string checksum(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : bytes)
        hash = (hash ^ static_cast<unsigned char>(c)) * std::uint64_t{1099511628211u};
    return fmt::format("{:016x}", hash);
}
}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
    const Json head{{"progress", checkpoint.progress},
                    {"bytes", checkpoint.state.size()},
                    {"checksum", checksum(one_line(checkpoint.progress) + checkpoint.state)}};
    write_file(file, std::string(kind) + one_line(head) + "\n" + checkpoint.state);
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    const auto reject = [&](const std::string& found) {
        throw plumbline::InvalidInput(
            fmt::format("{}: expected a checkpoint of plumbline, found {}", file.string(), found));
    };
    const std::size_t end = text.find('\n', kind.size());
    if (!text.starts_with(kind) || end == std::string::npos) reject("another file");
    const Json head = parse_json(std::string_view(text).substr(kind.size(), end - kind.size()));
    Checkpoint checkpoint{head.value("progress", Json::object()), text.substr(end + 1)};
    if (!head.is_object() || head.value("bytes", std::size_t{0}) != checkpoint.state.size())
        reject("one that was cut short");
    if (head.value("checksum", "") != checksum(one_line(checkpoint.progress) + checkpoint.state))
        reject("a damaged one");
    return checkpoint;
}

}  // namespace reports
