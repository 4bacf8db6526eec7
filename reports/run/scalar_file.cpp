#include "reports/run/scalar_file.h"

#include "solver/io/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace reports {

namespace {
namespace fs = std::filesystem;
using plumbline::CsvWriter;
using plumbline::SceneFile;

std::vector<std::string> columns(const SceneFile& scene) {
    std::vector<std::string> names{
        "time", "step", "dt", "limit", "kinetic_energy", "potential_energy", "internal_energy"};
    const auto add_vector = [&](const std::string& name) {
        for (int d = 0; d < scene.dim; ++d) names.push_back(fmt::format("{}_{}", name, "xyz"[d]));
    };
    add_vector("momentum");
    if (scene.dim == 3)
        add_vector("angular_momentum");
    else
        names.push_back("angular_momentum");
    add_vector("centre");
    for (const char* name : {"front", "height", "largest_speed"}) names.emplace_back(name);
    for (const plumbline::Probe& probe : scene.probes) names.push_back(probe.name);
    return names;
}
}  // namespace

ScalarFile::ScalarFile(fs::path file, const SceneFile& scene, std::size_t keep)
    : file_{std::move(file)} {
    if (keep > 0) {
        std::error_code error;
        if (const auto size = fs::file_size(file_, error); error || size < keep)
            throw plumbline::InvalidInput(fmt::format(
                "{}: expected the {} bytes that the checkpoint speaks of", file_.string(), keep));
        fs::resize_file(file_, keep);
        bytes_ = keep;
        return;
    }
    fs::remove(file_);
    std::ostringstream header;
    CsvWriter(header, columns(scene));
    append(std::move(header).str());
}

void ScalarFile::add(double time, std::size_t step, double dt, std::string_view why,
                     const SceneFile& scene, const plumbline::Snapshot& particles) {
    const plumbline::Scalars all = scalars_of(scene, particles);
    std::ostringstream text;
    CsvWriter row(text, columns(scene));
    const std::size_t header = text.view().size();
    const auto add_vector = [&](const plumbline::Vec<3>& v) {
        for (int d = 0; d < scene.dim; ++d) row.add(v[d]);
    };
    row.add(time).add(std::to_string(step)).add(dt).add(why);
    row.add(all.kinetic).add(all.potential).add(all.internal);
    add_vector(all.momentum);
    if (scene.dim == 3)
        add_vector(all.angular_momentum);
    else
        row.add(all.angular_momentum[2]);
    add_vector(all.centre);
    row.add(all.front).add(all.height).add(all.largest_speed);
    for (const plumbline::Probe& probe : scene.probes) {
        const double value = plumbline::reading(probe, scene, particles);
        if (std::isnan(value))
            row.add("");
        else
            row.add(value);
    }
    row.end_row();
    append(text.str().substr(header));
}

void ScalarFile::append(const std::string& text) {
    std::ofstream out(file_, std::ios::binary | std::ios::app);
    out << text << std::flush;
    if (!out) {
        out.close();
        std::error_code ignored;  // what is on the disk is then not ours to mend
        fs::resize_file(file_, bytes_, ignored);
        throw std::runtime_error("cannot write " + file_.string());
    }
    bytes_ += text.size();
}

}  // namespace reports
