#pragma once

#include "verification/reports/program.h"

#include <cstdlib>

namespace verification {

/// Whether libxml2 reads the file.
inline bool is_well_formed(const ScratchFolder& folder, const std::string& file) {
    return std::system(("xmllint --noout '" + (folder.path() / file).string() + "'").c_str()) == 0;
}

}  // namespace verification
