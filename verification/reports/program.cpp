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

ProgramRun run_plumbline(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                         int seconds) {
    std::string command = "cd " + quoted(folder.path().string()) + " && timeout -s KILL " +
                          std::to_string(seconds) + " " + quoted(PLUMBLINE_PROGRAM);
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    command += " </dev/null >.stdout 2>.stderr";
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, folder.read(".stdout"), folder.read(".stderr")};
}

}  // namespace verification
