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

bool is_open(const SceneFile& scene) { return !scene.emitters.empty() || !scene.outflows.empty(); }

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
    if (is_open(scene))
        for (const char* name :
             {"particles", "emitted", "emitted_mass", "blocked", "removed", "removed_mass"})
            names.emplace_back(name);
    for (const plumbline::SceneBody& body : scene.bodies) {
        for (const char* what : {"centre", "velocity", "force"}) add_vector(body.name + "_" + what);
        for (const char* what : {"turn", "spin", "torque"}) {
            if (scene.dim == 3)
                add_vector(body.name + "_" + what);
            else
                names.push_back(body.name + "_" + what);
        }
    }
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
    const auto add_turning = [&](const plumbline::Vec<3>& v) {
        if (scene.dim == 3)
            add_vector(v);
        else
            row.add(v[2]);
    };
    add_turning(all.angular_momentum);
    add_vector(all.centre);
    row.add(all.front).add(all.height).add(all.largest_speed);
    for (const plumbline::Probe& probe : scene.probes) {
        const double value = plumbline::reading(probe, scene, particles);
        if (std::isnan(value))
            row.add("");
        else
            row.add(value);
    }
    if (is_open(scene)) {
        row.add(static_cast<double>(particles.size()));
        row.add(particles.emitted.particles).add(particles.emitted.mass);
        row.add(particles.emitted.blocked);
        row.add(particles.removed.particles).add(particles.removed.mass);
    }
    for (const plumbline::BodyState& body : particles.bodies) {
        add_vector(body.centre), add_vector(body.velocity), add_vector(body.force);
        add_turning(body.turn), add_turning(body.spin), add_turning(body.torque);
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
