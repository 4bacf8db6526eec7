#include "reports/provenance.h"

#include "reports/git_describe.h"
#include "solver/foundation/parallel.h"
#include "verification/framework/property.h"

#include <CGAL/version.h>
#include <fmt/chrono.h>
#include <gsl/gsl_version.h>
#include <unistd.h>
#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <ctime>
#include <fstream>

namespace reports {

namespace {
struct Start {
    std::string command_line;
    std::time_t time = std::time(nullptr);
} start;

/// The value of the first line "key : value" of a file of /proc; empty if there is none.
std::string first_value(const char* file, std::string_view key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key)) {
            const auto value = line.find_first_not_of(" \t:", key.size());
            return value == std::string::npos ? "" : line.substr(value);
        }
    return "";
}

std::map<std::string, std::string> library_versions() {
    return {
        {"Eigen",
         fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"GSL", GSL_VERSION},
        {"CGAL", CGAL_STR(CGAL_VERSION)},
        {"Boost", BOOST_LIB_VERSION},
        {"fmt", fmt::format("{}", FMT_VERSION)},
        {"CLI11", CLI11_VERSION},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
        {"OpenMP", fmt::format("{}", _OPENMP)}};
}
}  // namespace

Provenance provenance() {
    Provenance p;
    p.version = PLUMBLINE_GIT_DESCRIBE;
    p.compiler = PLUMBLINE_COMPILER;
    p.flags = PLUMBLINE_FLAGS;
    p.processor = first_value("/proc/cpuinfo", "model name");
    p.cores = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    p.memory_gb = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                  static_cast<double>(sysconf(_SC_PAGE_SIZE)) * 1e-9;
    p.threads = plumbline::thread_count();
    p.libraries = library_versions();
    p.seeds = {{"properties", fmt::format("{}", verification::Cases{}.seed)},
               {"studies", "1, 2, ..., one for each set of samples"}};
    p.command_line = start.command_line;
    p.started = fmt::format("{:%FT%TZ}", fmt::gmtime(start.time));
    return p;
}

void remember_command_line(int argc, char** argv) {
    start.command_line = "plumbline";
    for (int k = 1; k < argc; ++k) start.command_line.append(" ").append(argv[k]);
}

}  // namespace reports
