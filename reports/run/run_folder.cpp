#include "reports/run/run_folder.h"

#include "reports/files.h"
#include "reports/process.h"
#include "reports/provenance.h"
#include "reports/run/checkpoint_file.h"
#include "reports/run/frame_picture.h"
#include "reports/run/scene_surface.h"
#include "solver/io/poly_data.h"

#include <fmt/format.h>

#include <sstream>

namespace reports {

namespace {
namespace fs = std::filesystem;
using plumbline::InvalidInput;
using plumbline::PolyData;
using plumbline::Snapshot;

std::string vtp_of(const PolyData& data) {
    std::ostringstream out;
    plumbline::write_vtp(out, data);
    return std::move(out).str();
}
std::vector<double> copy(std::span<const double> numbers) {
    return {numbers.begin(), numbers.end()};
}
PolyData particles_of(const Snapshot& s) {
    return {.xyz = plumbline::in_space(s.x, s.dim),
            .arrays = {{"velocity", 3, plumbline::in_space(s.v, s.dim)},
                       {"mass", 1, copy(s.m)},
                       {"density", 1, copy(s.rho)},
                       {"pressure", 1, copy(s.p)}}};
}
/// The ghosts of bodies, or those of walls.
PolyData ghosts_of(const Snapshot& s, bool of_bodies) {
    const auto dim = static_cast<std::size_t>(s.dim);
    std::vector<double> x, v, body;
    for (std::size_t k = 0; k * dim < s.ghosts.size(); ++k) {
        const bool in_body = !s.body_of_ghost.empty() && s.body_of_ghost[k] < s.bodies.size();
        if (in_body != of_bodies) continue;
        if (in_body) body.push_back(s.body_of_ghost[k] + 1.0);
        for (std::size_t d = 0; d < dim; ++d) {
            x.push_back(s.ghosts[k * dim + d]);
            v.push_back(s.ghost_v[k * dim + d]);
        }
    }
    PolyData data{.xyz = plumbline::in_space(x, s.dim), .arrays = {}};
    if (of_bodies)
        data.arrays = {{"velocity", 3, plumbline::in_space(v, s.dim)},
                       {"body", 1, std::move(body)}};
    return data;
}
std::string member(const std::string& name, std::size_t frame, const std::string& format) {
    return fmt::format("{0}/{0}_{1:05}.{2}", name, frame, format);
}

Json json_of(const RunRecord& record) {
    return {{"time", record.time},
            {"steps", record.steps},
            {"scalar_rows", record.scalar_rows},
            {"frames", record.frames},
            {"decided", record.decided},
            {"smallest_step", number(record.smallest_step)},
            {"seconds", record.seconds},
            {"dt", record.dt},
            {"why", record.why}};
}
RunRecord record_of(const Json& json) {
    RunRecord record;
    json.at("time").get_to(record.time);
    json.at("steps").get_to(record.steps);
    json.at("scalar_rows").get_to(record.scalar_rows);
    json.at("frames").get_to(record.frames);
    json.at("decided").get_to(record.decided);
    if (json.at("smallest_step").is_number()) json.at("smallest_step").get_to(record.smallest_step);
    json.at("seconds").get_to(record.seconds);
    json.at("dt").get_to(record.dt);
    json.at("why").get_to(record.why);
    return record;
}
constexpr const char* files[] = {"scene.toml",    "manifest.json", "scalars.csv", "particles.pvd",
                                 "surface.pvd",   "bodies.pvd",    "walls.vtp",   "checkpoint",
                                 "last_good.vtp", "film.mp4"};
constexpr const char* folders[] = {"particles", "surface", "bodies", "pictures"};
}  // namespace

bool RunFolder::holds_run() const { return fs::exists(folder_ / "scalars.csv"); }

void RunFolder::clear() const {
    for (const char* file : files) fs::remove(folder_ / file);
    for (const char* folder : folders) fs::remove_all(folder_ / folder);
}

void RunFolder::begin(const Snapshot& particles) {
    fs::create_directories(folder_ / "particles");
    if (scene_.surface) fs::create_directories(folder_ / "surface");
    if (scene_.picture != "none") fs::create_directories(folder_ / "pictures");
    write_file(folder_ / "scene.toml", scene_.text);
    if (!scene_.bodies.empty()) fs::create_directories(folder_ / "bodies");
    if (const PolyData walls = ghosts_of(particles, false); !walls.xyz.empty())
        write_file(folder_ / "walls.vtp", vtp_of(walls));
    scalars_.emplace(folder_ / "scalars.csv", scene_, 0);
}

std::string RunFolder::resume(RunRecord& record) {
    Checkpoint checkpoint = reports::read_checkpoint(folder_ / "checkpoint");
    const Json& progress = checkpoint.progress;
    if (progress.value("scene", "") != scene_.text)
        throw InvalidInput(fmt::format(
            "{}: expected the scene that the run in {} began with (its copy there: scene.toml), "
            "found another one",
            scene_.name, folder_.string()));
    record = record_of(progress.at("record"));
    scalars_.emplace(folder_ / "scalars.csv", scene_,
                     progress.at("bytes_of_scalars").get<std::size_t>());
    return std::move(checkpoint.state);
}

void RunFolder::add_scalars(const RunRecord& record, const Snapshot& particles) {
    scalars_->add(record.time, record.steps, record.dt, record.why, scene_, particles);
}

void RunFolder::add_frame(const RunRecord& record, const Snapshot& particles) {
    const std::size_t frame = record.frames.size() - 1;
    write_file(folder_ / member("particles", frame, "vtp"), vtp_of(particles_of(particles)));
    write_series(record, "particles", "vtp");
    if (!scene_.bodies.empty()) {
        write_file(folder_ / member("bodies", frame, "vtp"), vtp_of(ghosts_of(particles, true)));
        write_series(record, "bodies", "vtp");
    }
    if (scene_.surface) {
        const std::string& format = scene_.surface->format;
        write_file(folder_ / member("surface", frame, format), surface_text(scene_, particles));
        if (format == "vtp") write_series(record, "surface", format);
    }
    if (scene_.picture != "none")
        draw_frame(folder_ / fmt::format("pictures/frame_{:05}.png", frame), scene_, record.time,
                   particles);
}

void RunFolder::write_series(const RunRecord& record, const std::string& name,
                             const std::string& format) const {
    std::vector<plumbline::SeriesMember> members;
    for (std::size_t k = 0; k < record.frames.size(); ++k)
        members.push_back({record.frames[k], member(name, k, format)});
    std::ostringstream out;
    plumbline::write_pvd(out, members);
    write_file(folder_ / (name + ".pvd"), std::move(out).str());
}

void RunFolder::write_checkpoint(const RunRecord& record, std::string state) const {
    reports::write_checkpoint(folder_ / "checkpoint", {Json{{"scene", scene_.text},
                                                            {"bytes_of_scalars", scalars_->bytes()},
                                                            {"record", json_of(record)}},
                                                       std::move(state)});
}

void RunFolder::write_last_good(const Snapshot& particles) const {
    write_file(folder_ / "last_good.vtp", vtp_of(particles_of(particles)));
}

Json RunFolder::write_manifest(const RunRecord& record, const std::string& status,
                               const Snapshot& particles) const {
    Json manifest{
        {"schema", "plumbline.run/1"},
        {"provenance", json_of(provenance())},
        {"scene", {{"file", scene_.name}, {"title", scene_.title}, {"text", scene_.text}}},
        {"status", status},
        {"dim", scene_.dim},
        {"particles", particles.size()},
        {"ghosts", particles.ghosts.size() / static_cast<std::size_t>(particles.dim)},
        {"time", record.time},
        {"end", scene_.end},
        {"steps", record.steps},
        {"steps_decided_by", record.decided},
        {"smallest_step", number(record.smallest_step)},
        {"frames", record.frames},
        {"computing_s", record.seconds}};
    write_file(folder_ / "manifest.json", lines(manifest));
    return manifest;
}

void RunFolder::make_film() const {
    if (scene_.picture == "none") return;
    const auto result = run_process({"ffmpeg", "-y", "-loglevel", "error", "-framerate", "25", "-i",
                                     (folder_ / "pictures/frame_%05d.png").string(), "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p",
                                     (folder_ / "film.mp4").string()});
    if (!result)
        fmt::print(stderr, "plumbline: no film, since ffmpeg is not installed\n");
    else if (result->exit_code != 0)
        fmt::print(stderr, "plumbline: no film, since ffmpeg failed: {}\n", result->output);
}

}  // namespace reports
