#pragma once

#include <optional>
#include <string>
#include <vector>

namespace reports {

/// What a child process wrote (both streams together, or only stdout) and how it ended.
struct ProcessResult {
    int exit_code;  // 128 + n when signal n ended it
    std::string output;
};

enum class Streams { both, stdout_only };

/// Runs `arguments[0]`, searched in PATH, without a shell and without input, and waits for it.
/// Empty if there is no such program.
std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                         Streams streams = Streams::both);

}  // namespace reports
