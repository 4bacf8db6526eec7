#include "reports/commands/command.h"
#include "reports/interrupt.h"
#include "reports/provenance.h"
#include "solver/foundation/errors.h"
#include "solver/foundation/parallel.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace {
using reports::ExitCode;

int code(ExitCode exit) { return static_cast<int>(exit); }

/// CLI11 says only that a command is missing, even where one was mistyped.
int explain_missing_command(const std::vector<std::string>& found) {
    std::string expected;
    for (const reports::Command& command : reports::commands()) expected += " " + command.name;
    const std::string what =
        found.empty() ? "no command given" : "no command \"" + found.front() + "\"";
    std::fprintf(stderr, "plumbline: %s; expected one of:%s\n", what.c_str(), expected.c_str());
    return code(ExitCode::bad_input);
}
}  // namespace

int main(int argc, char** argv) {
    reports::remember_command_line(argc, argv);
    reports::note_interrupts();
    CLI::App app{"Plumbline: is the method right, what does accuracy cost, where does it break?"};
    app.require_subcommand(1);
    app.fallthrough();
    int threads = 0;
    app.add_option("--threads", threads, "threads to use (default: all)")
        ->check(CLI::Range(1, 4096));

    ExitCode exit = ExitCode::ok;
    for (const reports::Command& command : reports::commands()) {
        CLI::App* sub = app.add_subcommand(command.name, command.description);
        sub->callback([&exit, &threads, run = command.declare(*sub)] {
            if (threads > 0) plumbline::set_thread_count(threads);
            exit = run();
        });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_name() == "RequiredError" && app.get_subcommands().empty())
            return explain_missing_command(app.remaining());
        return app.exit(e) == 0 ? code(ExitCode::ok) : code(ExitCode::bad_input);
    } catch (const plumbline::InvalidInput& e) {
        std::fprintf(stderr, "plumbline: %s\n", e.what());
        return code(ExitCode::bad_input);
    } catch (const reports::Interrupted& e) {
        std::fprintf(stderr, "plumbline: %s\n", e.what());
        return code(ExitCode::interrupted);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "plumbline: %s\n", e.what());
        return code(ExitCode::crashed);
    }
    return code(exit);
}
