#include "reports/run/run_scene.h"

#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/scenes.h"
#include "solver/io/scene_meshes.h"

#include <csignal>
#include <memory>

namespace reports::run_command {
namespace {
struct Options {
    std::string scene;
    RunOptions run;
};

ExitCode run(Options options) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large then fails like a full disk
    const std::filesystem::path file = scene_path(options.scene);
    if (options.run.folder.empty()) options.run.folder = file.stem().string() + "_run";
    plumbline::SceneFile scene = plumbline::SceneFile::read(file);
    plumbline::read_meshes(scene);
    run_scene(scene, options.run);
    return ExitCode::ok;
}

const RegisterCommand command{
    {"run", "a simulation of a scene file: ParaView series, scalars, pictures, a manifest",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("scene", options->scene, "the scene file, or the name of an example")
             .required();
         line.add_option("-o,--output", options->run.folder,
                         "the folder to write into (default: the name of the scene and \"_run\")")
             .check(output_folder());
         line.add_option("--steps", options->run.steps, "stop after so many steps")
             .check(between(std::size_t{1}, std::size_t{1} << 40));
         const auto go_on = line.add_flag("--continue", options->run.go_on,
                                          "go on with the run that is in the folder");
         line.add_flag("--overwrite", options->run.overwrite, "delete a run that is in the folder")
             .excludes(go_on);
         line.add_option("--json", options->run.json,
                         "write the manifest to this file, too, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return run(*options); };
     }}};
}  // namespace
}  // namespace reports::run_command
