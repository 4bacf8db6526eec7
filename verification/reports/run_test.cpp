#include "verification/reports/program.h"

#include "solver/io/csv.h"
#include "solver/io/read_points.h"
#include "verification/io/xml_check_test.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace run_test {
namespace {
using namespace verification;
namespace fs = std::filesystem;

/// A folder with a scene file s.toml that ends after 0.06 s, at its third frame.
struct SceneFolder : ScratchFolder {
    explicit SceneFolder(int dim = 2, const std::string& method = "delta_sph") {
        write("s.toml", dam_break_scene(dim, method, 0.06));
    }
    ProgramRun run(std::vector<std::string> more, const std::string& before = ":") const {
        more.insert(more.begin(), {"run", "s.toml"});
        if (std::ranges::find(more, "--threads") == more.end())
            more.insert(more.end(), {"--threads", "1"});
        return run_plumbline(*this, more, 60, before);
    }
    nlohmann::json manifest(const std::string& run) const {
        return nlohmann::json::parse(read(run + "/manifest.json"));
    }
};

/// The files of two runs that should be the same, byte by byte.
void check_equal_runs(const SceneFolder& folder, const std::string& one, const std::string& other) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / one)) {
        const std::string file = fs::relative(entry.path(), folder.path() / one).string();
        if (!entry.is_regular_file() || file == "manifest.json" || file == "checkpoint") continue;
        INFO(file);
        CHECK(folder.read(one + "/" + file) == folder.read(other + "/" + file));
        ++files;
    }
    CHECK(files >= 7);  // 4 frames, the series, scalars, the scene
}

TEST_CASE("run writes series, scalars and a manifest that can be read") {
    const SceneFolder folder;
    const ProgramRun run = folder.run({"-o", "out"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.empty());
    for (const char* file :
         {"out/particles.pvd", "out/walls.vtp", "out/particles/particles_00003.vtp"})
        CHECK(is_well_formed(folder, file));
    const auto particles =
        plumbline::read_points(folder.path() / "out/particles/particles_00003.vtp");
    CHECK(particles.size() == 450);
    CHECK(particles.find("pressure"));
    CHECK(particles.find("velocity_1"));
    const auto scalars = plumbline::CsvTable::read(folder.path() / "out/scalars.csv");
    CHECK(scalars.numbers("time").front() == 0.0);
    CHECK(scalars.numbers("time").back() == 0.06);
    CHECK(scalars.rows() >= 30);
    const auto manifest = folder.manifest("out");
    CHECK(manifest.at("schema") == "plumbline.run/1");
    CHECK(manifest.at("status") == "finished");
    CHECK(manifest.at("frames").size() == 4);
    CHECK(manifest.at("steps_decided_by").at("output").get<int>() <= 2 * 3);
    CHECK_FALSE(manifest.at("provenance").at("version").get<std::string>().empty());
}

TEST_CASE("a run in pieces, on one thread and on two, writes what one in one go does") {
    for (const int dim : {2, 3})
        for (const char* method : {"delta_sph", "sph", "dfsph"}) {
            const SceneFolder folder(dim, method);
            REQUIRE(folder.run({"-o", "whole", "--threads", "2"}).exit_code == 0);
            REQUIRE(folder.run({"-o", "pieces", "--threads", "1", "--steps", "7"}).exit_code == 0);
            CHECK(folder.manifest("pieces").at("status") == "stopped");
            REQUIRE(folder.run({"-o", "pieces", "--continue", "--steps", "20"}).exit_code == 0);
            REQUIRE(folder.run({"-o", "pieces", "--continue"}).exit_code == 0);
            check_equal_runs(folder, "whole", "pieces");
        }
}

TEST_CASE("Ctrl-C ends a run with 130, files that can be read, and a way to go on") {
    const SceneFolder folder(3);
    REQUIRE(folder.run({"-o", "whole"}).exit_code == 0);
    const ProgramRun stopped = interrupt_plumbline(
        folder, {"run", "s.toml", "-o", "cut", "--threads", "1"}, "cut/scalars.csv", 1000);
    INFO(stopped.err);
    CHECK(stopped.exit_code == 130);
    CHECK(folder.manifest("cut").at("status") == "interrupted");
    CHECK(is_well_formed(folder, "cut/particles.pvd"));
    CHECK_NOTHROW(plumbline::CsvTable::read(folder.path() / "cut/scalars.csv"));
    REQUIRE(folder.run({"-o", "cut", "--continue"}).exit_code == 0);
    check_equal_runs(folder, "whole", "cut");
}

TEST_CASE("a full disk ends a run with 4, files that can be read, and a way to go on") {
    SceneFolder folder;
    // Rows are many, so that scalars.csv outgrows 128 KiB, which all other files stay below.
    folder.write("s.toml", dam_break_scene(2, "sph", 0.06) + "scalars = 1e-5\n[time_of_nothing]\n");
    folder.write("s.toml", with(folder.read("s.toml"), "[time_of_nothing]\n", ""));
    folder.write("s.toml", with(folder.read("s.toml"), "[time]", "[time]\nstep = 1e-4"));
    REQUIRE(folder.run({"-o", "whole"}).exit_code == 0);
    const ProgramRun stopped = folder.run({"-o", "full"}, "ulimit -f 256");
    INFO(stopped.err);
    CHECK(stopped.exit_code == 4);
    CHECK(stopped.err.find("cannot write full/scalars.csv") != std::string::npos);
    CHECK(stopped.err.find("--continue goes on") != std::string::npos);
    CHECK(is_well_formed(folder, "full/particles.pvd"));
    CHECK(plumbline::CsvTable::read(folder.path() / "full/scalars.csv").rows() > 100);
    REQUIRE(folder.run({"-o", "full", "--continue"}).exit_code == 0);
    check_equal_runs(folder, "whole", "full");
}

TEST_CASE("a step that is too long ends with 4, its reason, and the last good state") {
    const SceneFolder folder;
    folder.write("s.toml",
                 with(dam_break_scene(2, "delta_sph", 1.0), "[time]", "[time]\nstep = 0.02"));
    const ProgramRun run = folder.run({"-o", "out"});
    INFO(run.err);
    CHECK(run.exit_code == 4);
    CHECK(run.err.find("particle ") != std::string::npos);
    CHECK(run.err.find("the term ") != std::string::npos);
    CHECK(folder.manifest("out").at("status") == "failed");
    CHECK(plumbline::read_points(folder.path() / "out/last_good.vtp").size() == 450);
}

TEST_CASE("a folder with a run is neither overwritten nor continued without being asked to") {
    const SceneFolder folder;
    REQUIRE(folder.run({"-o", "out", "--steps", "1"}).exit_code == 0);
    CHECK(folder.run({"-o", "out"}).exit_code == 2);
    CHECK(folder.run({"-o", "out", "--overwrite", "--steps", "1"}).exit_code == 0);
    folder.write("s.toml", with(folder.read("s.toml"), "alpha = 0.1", "alpha = 0.2"));
    const ProgramRun other = folder.run({"-o", "out", "--continue"});
    CHECK(other.exit_code == 2);
    CHECK(other.err.find("expected the scene that the run in out began with") != std::string::npos);
}

TEST_CASE("damaged checkpoints are refused") {
    const SceneFolder folder;
    REQUIRE(folder.run({"-o", "out", "--steps", "3"}).exit_code == 0);
    const std::string good = folder.read("out/checkpoint");
    std::string bad = good;
    bad[bad.size() - 100] = static_cast<char>(bad[bad.size() - 100] + 1);
    for (const auto& [bytes, found] :
         {std::pair{bad, "a damaged one"}, std::pair{good.substr(0, good.size() - 8), "cut short"},
          std::pair{std::string("x"), "another file"}}) {
        folder.write("out/checkpoint", bytes);
        const ProgramRun run = folder.run({"-o", "out", "--continue"});
        INFO(run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.err.find(found) != std::string::npos);
    }
}

TEST_CASE("surfaces and pictures are written when asked for") {
    for (const int dim : {2, 3}) {
        const SceneFolder folder(dim);
        std::string text = with(dam_break_scene(dim, "delta_sph", 0.02), "picture = \"none\"",
                                "picture = \"pressure\"");
        folder.write("s.toml", text + "[output.surface]\nfield = \"weighted_average\"\n");
        const ProgramRun run = folder.run({"-o", "out"});
        INFO(run.err);
        REQUIRE(run.exit_code == 0);
        CHECK(folder.read("out/pictures/frame_00001.png").substr(1, 3) == "PNG");
        CHECK(is_well_formed(folder, "out/surface.pvd"));
        CHECK(is_well_formed(folder, "out/surface/surface_00001.vtp"));
    }
}

TEST_CASE("bodies, and what comes and goes, are in scalars, series and checkpoints") {
    const SceneFolder folder;
    folder.write(
        "s.toml",
        folder.read("s.toml") +
            "[[body]]\nname = \"block\"\nshape = \"box\"\nlow = [0.7, 0]\nhigh = [0.8, 0.1]\n"
            "density = 500\n[[emitter]]\ncentre = [0.3, 0.5]\ndirection = [0, -1]\n"
            "radius = 0.05\nspeed = 2\n[[outflow]]\nshape = \"plane\"\npoint = [0.6, 0]\n"
            "normal = [-1, 0]\n[domain]\nlow = [-1, -1]\nhigh = [2, 2]\n");
    const ProgramRun run = folder.run({"-o", "whole", "--threads", "2"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const auto scalars = plumbline::CsvTable::read(folder.path() / "whole/scalars.csv");
    CHECK(scalars.numbers("block_centre_x").front() == Approx(0.75));
    CHECK(scalars.numbers("block_centre_y").back() == Approx(0.05).margin(1e-6));
    CHECK(scalars.numbers("block_turn").back() == Approx(0.0).margin(1e-3));
    CHECK(scalars.numbers("emitted").back() == 5.0 * 6.0);  // layers at 0, 0.01, ..., 0.05 s
    CHECK(scalars.numbers("emitted_mass").back() == Approx(30.0 * 0.4));
    CHECK(scalars.numbers("removed").back() > 0.0);
    CHECK(scalars.numbers("particles").back() == 450.0 + 30.0 - scalars.numbers("removed").back());
    CHECK(is_well_formed(folder, "whole/bodies.pvd"));
    CHECK(plumbline::read_points(folder.path() / "whole/bodies/bodies_00003.vtp").size() == 25);
    REQUIRE(folder.run({"-o", "pieces", "--steps", "30"}).exit_code == 0);
    REQUIRE(folder.run({"-o", "pieces", "--continue"}).exit_code == 0);
    check_equal_runs(folder, "whole", "pieces");
}

TEST_CASE("a run that ends makes a film of its pictures, with ffmpeg") {
    const SceneFolder folder;
    folder.write("s.toml", with(dam_break_scene(2, "sph", 0.02), "picture = \"none\"", ""));
    // Stands in for ffmpeg, of which no test may depend: what it is asked for, in the file it is to write.
    folder.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\necho \"$@\" >\"$last\"\n");
    const ProgramRun run =
        folder.run({"-o", "out", "--json", "-"}, "chmod +x ffmpeg && export PATH=\"$PWD:$PATH\"");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(folder.read("out/film.mp4").find("-i out/pictures/frame_%05d.png") != std::string::npos);
    CHECK(nlohmann::json::parse(run.out) == folder.manifest("out"));
}

/// The last value of a column of scalars.csv of an example, run to its end.
double at_the_end(const ScratchFolder& folder, const std::string& scene,
                  const std::string& column) {
    if (!fs::exists(folder.path() / scene)) {
        // Without pictures, which take longer than the steps.
        const ProgramRun list = run_plumbline(folder, {"list", "scenes", "--json", "-"});
        std::string text;
        const auto scenes = nlohmann::json::parse(list.out).at("list").at("scenes");
        for (const auto& row : scenes)
            if (row.at("id") == scene) text = row.at("text");
        const std::size_t picture = text.find("picture = ");
        text.replace(picture, text.find('\n', picture) - picture, "picture = \"none\"");
        folder.write(scene + ".toml", text);
        const ProgramRun run =
            run_plumbline(folder, {"run", scene + ".toml", "-o", scene, "--threads", "1"}, 300);
        INFO(run.err);
        REQUIRE(run.exit_code == 0);
    }
    return plumbline::CsvTable::read(folder.path() / scene / "scalars.csv").numbers(column).back();
}

TEST_CASE("examples end where theory says") {
    const ScratchFolder folder;
    // The edge of a drop of particles lies half a spacing, 0.025 m, beyond the last one, and is known to that.
    CHECK(at_the_end(folder, "drop", "height") + 0.025 == Approx(1.9445).margin(0.025));
    CHECK(at_the_end(folder, "drop", "front") + 0.025 == Approx(0.5143).margin(0.025));
    // A particle's depth is known to half a spacing: 0.025 m of water.
    CHECK(at_the_end(folder, "hydrostatic", "half_depth") == Approx(0.5).margin(0.025));
}

TEST_CASE("the example scenes are listed, and each can take a step") {
    const ScratchFolder folder;
    const ProgramRun list = run_plumbline(folder, {"list", "scenes", "--json", "-"});
    REQUIRE(list.exit_code == 0);
    const auto scenes = nlohmann::json::parse(list.out).at("list").at("scenes");
    REQUIRE(scenes.size() >= 4);
    for (const auto& scene : scenes) {
        const std::string name = scene.at("id");
        INFO(name);
        CHECK(run_plumbline(folder, {"run", name, "-o", name, "--steps", "1", "--threads", "1"})
                  .exit_code == 0);
    }
}
}  // namespace
}  // namespace run_test
