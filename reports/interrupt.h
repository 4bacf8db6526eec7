#pragma once

#include <stdexcept>

namespace reports {

/// Ctrl-C, or a request to end: what is done is kept, the exit code is 130.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted; what is done is kept") {}
};

/// From now on SIGINT and SIGTERM are noted; a second one ends the program at once.
void note_interrupts();

/// Throws Interrupted if one was noted. Called between the pieces of long work.
void stop_if_interrupted();

}  // namespace reports
