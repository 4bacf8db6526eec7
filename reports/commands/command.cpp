#include "reports/commands/command.h"

#include <algorithm>

namespace reports {

namespace {
std::vector<Command>& registered() {
    static std::vector<Command> all;
    return all;
}
}  // namespace

std::vector<Command> commands() {
    std::vector<Command> all = registered();
    std::ranges::sort(all, {}, &Command::name);
    return all;
}

RegisterCommand::RegisterCommand(Command command) { registered().push_back(std::move(command)); }

}  // namespace reports
