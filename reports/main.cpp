#include "reports/commands/command.h"
#include "reports/interrupt.h"
#include "reports/provenance.h"
#include "solver/foundation/errors.h"
#include "solver/foundation/parallel.h"

#include <cstdio>
#include <map>

namespace {
using reports::ExitCode;

ExitCode run(int argc, char** argv) {
    reports::CommandLine line(
        "Plumbline: is the method right, what does accuracy cost, where does it break?");
    line.set_version("plumbline " + reports::provenance().version);
    int threads = 0;
    line.add_option("--threads", threads, "threads to use (default: all)")
        .check(reports::between(1, 4096));
    std::map<std::string, std::function<ExitCode()>> runs;
    for (const reports::Command& command : reports::commands()) {
        reports::CommandLine own = line.add_command(command.name, command.description);
        runs[command.name] = command.declare(own);
    }
    const auto request = line.parse(argc, argv);
    if (request.command.empty()) return request.understood ? ExitCode::ok : ExitCode::bad_input;
    if (threads > 0) plumbline::set_thread_count(threads);
    return runs.at(request.command)();
}

ExitCode end_with(ExitCode exit, const std::exception& reason) {
    std::fprintf(stderr, "plumbline: %s\n", reason.what());
    return exit;
}

ExitCode run_guarded(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const plumbline::InvalidInput& e) {
        return end_with(ExitCode::bad_input, e);
    } catch (const reports::Interrupted& e) {
        return end_with(ExitCode::interrupted, e);
    } catch (const std::exception& e) {
        return end_with(ExitCode::crashed, e);
    }
}
}  // namespace

int main(int argc, char** argv) {
    reports::remember_command_line(argc, argv);
    reports::note_interrupts();
    return static_cast<int>(run_guarded(argc, argv));
}
