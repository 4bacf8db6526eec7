#include "verification/reports/program.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace verification {

namespace {
/// As one word of a shell.
std::string quoted(const std::string& argument) {
    std::string word = "'";
    for (const char c : argument) {
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    }
    return word + "'";
}
}  // namespace

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "plumbline_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder like " + name);
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;  // a destructor has nobody to tell
    std::filesystem::remove_all(path_, ignored);
}

void ScratchFolder::write(const std::string& file, const std::string& bytes) const {
    std::ofstream out(path_ / file, std::ios::binary);
    if (!(out << bytes)) throw std::runtime_error("cannot write " + (path_ / file).string());
}

std::string ScratchFolder::read(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(path_ / file, std::ios::binary).rdbuf();
    return text.str();
}

namespace {
/// The program and its arguments, as a shell starts it.
std::string started(const std::vector<std::string>& arguments) {
    std::string command = quoted(PLUMBLINE_PROGRAM);
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    return command + " </dev/null >.stdout 2>.stderr";
}
ProgramRun run_in_shell(const ScratchFolder& folder, const std::string& command) {
    const int status =
        std::system(("cd " + quoted(folder.path().string()) + " && " + command).c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, folder.read(".stdout"), folder.read(".stderr")};
}
}  // namespace

ProgramRun run_plumbline(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                         int seconds, const std::string& before) {
    return run_in_shell(folder, before + " && timeout -s KILL " + std::to_string(seconds) + " " +
                                    started(arguments));
}

ProgramRun interrupt_plumbline(const ScratchFolder& folder,
                               const std::vector<std::string>& arguments, const std::string& file,
                               std::size_t bytes) {
    // In the end it is waited for in any case; timeout would not pass the signal on.
    return run_in_shell(folder, "{ " + started(arguments) + " & } && program=$! && " +
                                    "while kill -0 $program 2>/dev/null && [ \"$(stat -c %s " +
                                    quoted(file) + " 2>/dev/null || echo 0)\" -lt " +
                                    std::to_string(bytes) +
                                    " ]; do sleep 0.02; done; kill -INT $program; wait $program");
}

}  // namespace verification
