#pragma once

#include "reports/commands/command_line.h"

namespace reports {

// What an option of the command line must be: `line.add_option(…).check(positive_number())`.

/// Greater than zero, and finite.
Check positive_number();

/// A file that exists or can be made: its folder exists, and both may be written. `-` is stdout.
Check output_file();

/// A folder that may be written, or that can be made.
Check output_folder();

}  // namespace reports
