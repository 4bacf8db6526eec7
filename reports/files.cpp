#include "reports/files.h"

#include "solver/foundation/errors.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace reports {

void write_file(const std::filesystem::path& file, std::string_view text) {
    std::filesystem::path partial = file;
    partial += ".part";
    {
        std::ofstream out(partial, std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.flush();
        if (!out) {
            const std::string why = std::strerror(errno);
            out.close();
            std::filesystem::remove(partial);
            throw std::runtime_error("cannot write " + file.string() + ": " + why);
        }
    }
    std::filesystem::rename(partial, file);
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || std::filesystem::is_directory(file) || !(text << in.rdbuf()))
        throw plumbline::InvalidInput(file.string() + ": expected a file that can be read");
    return std::move(text).str();
}

}  // namespace reports
