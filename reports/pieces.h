#pragma once

#include "reports/json.h"

#include <filesystem>
#include <functional>
#include <string>

namespace reports {

/// Finished pieces of long work, one JSON file each, so that a run that was interrupted goes on where
/// it ended. A piece counts only if it was made under the same fingerprint.
class Pieces {
public:
    /// `directory` is created when the first piece is kept; an empty one keeps nothing.
    Pieces(std::filesystem::path directory, std::string fingerprint);

    /// The piece `key` ("claims/poly6.is_smooth"), made by `make` and kept if it is not there yet.
    Json get(const std::string& key, const std::function<Json()>& make);

    int reused() const { return reused_; }

private:
    std::filesystem::path directory_;
    std::string fingerprint_;
    int reused_ = 0;
};

/// Of this program (its version and its file), this machine, the number of threads and `options`:
/// what is equal in them may be taken from an earlier run.
std::string fingerprint(const std::string& options);

}  // namespace reports
