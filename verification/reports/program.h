#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace verification {

/// How a run of the program ended.
struct ProgramRun {
    int exit_code;  // 128 + n if signal n ended it: 137 if it ran out of time
    std::string out, err;
};

/// A folder of its own for each object, deleted with it.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& file, const std::string& bytes) const;
    std::string read(const std::string& file) const;  // empty if there is no such file

private:
    std::filesystem::path path_;
};

/// Runs the built `plumbline` in `folder`, with nothing on stdin, and kills it after `seconds`.
/// `before` is a command of the shell that starts it, as "ulimit -f 100".
ProgramRun run_plumbline(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                         int seconds = 60, const std::string& before = ":");

/// Starts it likewise, and interrupts it (Ctrl-C) once `file` in the folder has `bytes` bytes.
ProgramRun interrupt_plumbline(const ScratchFolder& folder,
                               const std::vector<std::string>& arguments, const std::string& file,
                               std::size_t bytes);

}  // namespace verification
