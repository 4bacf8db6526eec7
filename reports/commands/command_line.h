#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace reports {

/// What the text of an option must be.
struct Check {
    std::function<std::string(const std::string& text)> complaint;  // empty if the text is right
    std::string word;                                               // for the help: "FILE"
};

// The templates below are instantiated in command_line.cpp for the types that the commands use.

/// One of these values.
template <class T> Check one_of(const std::vector<T>& values);

/// Both ends included.
template <class T> Check between(T low, T high);

/// An option of a CommandLine, to say more about it.
class Option {
public:
    Option required() const;
    Option check(const Check& check) const;
    Option needs(Option other) const;
    Option excludes(Option other) const;

    /// The help tells the value that the variable has now.
    Option show_default() const;
    /// It may stand without a value, which is `value` then.
    Option alone_means(const std::string& value) const;
    /// Its values are one argument, "2,3", not one argument each.
    Option separated_by_commas() const;

private:
    friend class CommandLine;
    explicit Option(CLI::Option* option) : option_(option) {}
    CLI::Option* option_;
};

/// The options and the commands of the program, or of one of its commands. Copies are one and the same.
/// It is all of CLI11 that the program needs, without the seconds that its headers cost in each file.
class CommandLine {
public:
    explicit CommandLine(const std::string& description);

    /// Parsing writes to `value`, if the option is given. Names are "--long" or "-s,--long"; without
    /// dashes it is an argument known by its place.
    template <class T>
    Option add_option(const std::string& names, T& value, const std::string& description);
    Option add_flag(const std::string& names, bool& value, const std::string& description);

    /// `--version` writes `text` to stdout, and nothing is run.
    void set_version(const std::string& text);

    /// Exactly one of the commands has to be given; its options are added to the result.
    CommandLine add_command(const std::string& name, const std::string& description);

    struct Request {
        std::string command;  // the name of the one to run; empty if there is nothing to run,
        bool understood =
            true;  // because help or the version was asked for, or (false) the line is wrong
    };
    /// Writes help and version to stdout, and what is wrong to stderr.
    Request parse(int argc, const char* const* argv);

private:
    explicit CommandLine(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}
    std::shared_ptr<CLI::App> app_;
};

}  // namespace reports
