#pragma once

#include "reports/commands/command_line.h"

#include <functional>
#include <string>
#include <vector>

namespace reports {

enum class ExitCode {
    ok = 0,
    check_failed = 1,
    bad_input = 2,
    inconclusive = 3,  // or nothing matched
    crashed = 4,       // or ran out of time
    interrupted = 130
};

/// One command of the program. `declare` adds its options to the line and returns what to run
/// once they are parsed; that may throw plumbline::InvalidInput, which becomes exit code 2.
/// Data goes to stdout, talk to stderr.
struct Command {
    std::string name;
    std::string description;
    std::function<std::function<ExitCode()>(CommandLine&)> declare;
};

/// All registered commands, by name.
std::vector<Command> commands();

/// `const RegisterCommand r{{"list", …}};` in reports/commands/<name>.cpp; there is no other list.
struct RegisterCommand {
    explicit RegisterCommand(Command command);
};

}  // namespace reports
