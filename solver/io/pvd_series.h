#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace plumbline {

/// A file of a series, and the time that it shows.
struct SeriesMember {
    double time;       // [s]
    std::string file;  // relative to the .pvd
};

/// A ParaView collection: the files in the order of time.
void write_pvd(std::ostream& out, const std::vector<SeriesMember>& members);

}  // namespace plumbline
