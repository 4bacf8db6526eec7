#pragma once

#include <map>
#include <string>
#include <vector>

namespace reports {

/// Where a result comes from: enough to make it again, and to know what it may be compared with.
struct Provenance {
    std::string version;   // of Plumbline, by git describe; "unknown" outside of a repository
    std::string compiler;  // with its version
    std::string flags;
    std::string processor;
    int cores = 0;
    double memory_gb = 0.0;
    int threads = 0;
    std::map<std::string, std::string> libraries;  // name -> version
    std::map<std::string, std::string> seeds;      // what they are for -> value
    std::string command_line;
    std::string started;  // UTC, ISO 8601
};

/// Of this program on this machine, started with `arguments` (set once, by main).
Provenance provenance();
void remember_command_line(int argc, char** argv);

}  // namespace reports
