#pragma once

#include <CLI/CLI.hpp>

namespace reports {

// What an option of the command line must be: `app.add_option(…)->check(positive_number())`.

/// Greater than zero, and finite.
CLI::Validator positive_number();

/// A file that exists or can be made: its folder exists, and both may be written. `-` is stdout.
CLI::Validator output_file();

/// A folder that may be written, or that can be made.
CLI::Validator output_folder();

}  // namespace reports
