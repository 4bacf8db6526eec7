#include "reports/commands/command_line.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace reports {

namespace {
Check check_of(const CLI::Validator& validator) {
    return {[validator](std::string text) { return validator(text); }, validator.get_description()};
}

/// CLI11 says only that a command is missing, even where one was mistyped.
void explain_missing_command(const CLI::App& app) {
    std::string expected;
    for (const CLI::App* command : app.get_subcommands({})) expected += " " + command->get_name();
    const auto found = app.remaining();
    const std::string what =
        found.empty() ? "no command given" : "no command \"" + found.front() + "\"";
    std::fprintf(stderr, "plumbline: %s; expected one of:%s\n", what.c_str(), expected.c_str());
}
}  // namespace

template <class T> Check one_of(const std::vector<T>& values) {
    return check_of(CLI::IsMember(values));
}
template Check one_of(const std::vector<std::string>&);
template Check one_of(const std::vector<int>&);

template <class T> Check between(T low, T high) { return check_of(CLI::Range(low, high)); }
template Check between(int, int);
template Check between(std::uint32_t, std::uint32_t);
template Check between(std::size_t, std::size_t);

Option Option::required() const { return Option(option_->required()); }

Option Option::check(const Check& check) const {
    return Option(option_->check(check.complaint, check.word));
}

Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }

Option Option::excludes(Option other) const { return Option(option_->excludes(other.option_)); }

Option Option::show_default() const { return Option(option_->capture_default_str()); }

Option Option::alone_means(const std::string& value) const {
    return Option(option_->expected(0, 1)->default_str(value));
}

Option Option::separated_by_commas() const {
    return Option(option_->delimiter(',')->allow_extra_args(false));
}

CommandLine::CommandLine(const std::string& description)
    : app_(std::make_shared<CLI::App>(description)) {
    app_->fallthrough();
}

template <class T>
Option CommandLine::add_option(const std::string& names, T& value, const std::string& description) {
    return Option(app_->add_option(names, value, description));
}
template Option CommandLine::add_option(const std::string&, std::string&, const std::string&);
template Option CommandLine::add_option(const std::string&, int&, const std::string&);
template Option CommandLine::add_option(const std::string&, double&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::size_t&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::uint32_t&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::optional<double>&,
                                        const std::string&);
template Option CommandLine::add_option(const std::string&, std::vector<std::string>&,
                                        const std::string&);
template Option CommandLine::add_option(const std::string&, std::vector<int>&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::vector<double>&,
                                        const std::string&);
template Option CommandLine::add_option(const std::string&, std::vector<std::uint32_t>&,
                                        const std::string&);

Option CommandLine::add_flag(const std::string& names, bool& value,
                             const std::string& description) {
    return Option(app_->add_flag(names, value, description));
}

void CommandLine::set_version(const std::string& text) {
    app_->set_version_flag("--version", text);
}

CommandLine CommandLine::add_command(const std::string& name, const std::string& description) {
    app_->require_subcommand(1);
    // The program owns its commands; what is returned keeps the program.
    return CommandLine(std::shared_ptr<CLI::App>(app_, app_->add_subcommand(name, description)));
}

CommandLine::Request CommandLine::parse(int argc, const char* const* argv) {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_name() == "RequiredError" && app_->get_subcommands().empty()) {
            explain_missing_command(*app_);
            return {"", false};
        }
        return {"", app_->exit(e) == 0};
    }
    return {app_->get_subcommands().front()->get_name(), true};
}

}  // namespace reports
