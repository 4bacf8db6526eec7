#include "reports/run/run_scene.h"

#include "reports/interrupt.h"
#include "reports/run/run_folder.h"
#include "solver/scene/guarded_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <memory>

namespace reports {
namespace {
using plumbline::GuardedRun;
using plumbline::SceneFile;
using plumbline::Simulation;

/// A line on a terminal: how far the run is, and how long it still takes.
class Line {
public:
    explicit Line(double from) : from_{from} {}
    ~Line() {
        if (shown_) fmt::print(stderr, "\r\033[K");
    }
    void show(double time, double end, std::size_t step) {
        using namespace std::chrono;
        const auto now = steady_clock::now();
        if (!terminal_ || now - last_ < milliseconds(500)) return;
        last_ = now, shown_ = true;
        const double spent = duration<double>(now - start_).count();
        fmt::print(stderr, "\r\033[Kt = {:.4g} of {:.4g} s  step {}  about {:.0f} s left", time,
                   end, step, spent * (end - time) / (time - from_));
        std::fflush(stderr);
    }

private:
    double from_;
    bool terminal_ = isatty(STDERR_FILENO) != 0, shown_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_ = start_;
};

class Run {
public:
    Run(const SceneFile& scene, const RunOptions& options)
        : scene_{scene},
          folder_{options.folder, scene},
          simulation_{plumbline::make_simulation(scene)},
          guarded_{*simulation_, domain_of(scene, simulation_->snapshot())},
          most_steps_{options.steps},
          json_{options.json} {
        if (options.overwrite) folder_.clear();
        if (options.go_on) {
            simulation_->load(folder_.resume(record_));
            guarded_.restart_at(record_.time, record_.steps);
        } else if (folder_.holds_run()) {
            throw plumbline::InvalidInput(fmt::format(
                "{}: expected a folder without a run, found one; --continue goes on with it, "
                "--overwrite begins anew",
                options.folder));
        } else {
            folder_.begin(simulation_->snapshot());
            add_frame(0.0);
        }
    }

    void run() {
        try {
            const std::string status = advance();
            const Json manifest = folder_.write_manifest(record_, status, simulation_->snapshot());
            if (!json_.empty()) write_json(manifest, json_);
            if (status == "finished") folder_.make_film();
            fmt::print(stderr, "plumbline: {} at t = {:.6g} s after {} steps, in {}\n", status,
                       record_.time, record_.steps, folder_.path().string());
        } catch (const Interrupted&) {
            keep("interrupted");
            throw;
        } catch (const plumbline::SimulationFailed&) {
            folder_.write_last_good(simulation_->snapshot());
            keep("failed");
            throw;
        } catch (const std::runtime_error& e) {  // a file could not be written
            throw std::runtime_error(fmt::format(
                "{}; the run can be read up to its last frame, and --continue goes on from it",
                e.what()));
        }
    }

private:
    /// "finished", or "stopped" after as many steps as were asked for.
    std::string advance() {
        Line line(record_.time);
        std::size_t done = 0;
        while (record_.frames.back() < scene_.end) {
            if (most_steps_ > 0 && done++ == most_steps_) {
                save();
                return "stopped";
            }
            stop_if_interrupted();
            step();
            line.show(record_.time, scene_.end, record_.steps);
        }
        return "finished";
    }

    void step() {
        const double event = time_of_frame(record_.frames.size());
        const auto begin = std::chrono::steady_clock::now();
        const auto next = next_step(scene_, simulation_->limits(), record_.time, event);
        guarded_.step(next);
        record_.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        record_.time = guarded_.time(), record_.steps = guarded_.steps();
        record_.dt = next.dt, record_.why = next.why;
        ++record_.decided[record_.why];
        if (next.why != "output") record_.smallest_step = std::min(record_.smallest_step, next.dt);
        if (record_.time == event)
            add_frame(event);
        else if (record_.time >= time_of_row(record_.scalar_rows))
            add_row();
    }
    double time_of_frame(std::size_t frame) const {
        const double time = static_cast<double>(frame) * scene_.interval;
        return time < scene_.end * (1.0 - 1e-9) ? time : scene_.end;
    }
    double time_of_row(std::size_t row) const {
        return static_cast<double>(row) * scene_.scalar_interval * (1.0 - 1e-9);
    }
    void add_row() {
        folder_.add_scalars(record_, simulation_->snapshot());
        while (time_of_row(record_.scalar_rows) <= record_.time) ++record_.scalar_rows;
    }
    void add_frame(double time) {
        record_.frames.push_back(time);
        folder_.add_frame(record_, simulation_->snapshot());
        add_row();
        save();
    }
    void save() {
        std::string state;
        simulation_->save(state);
        folder_.write_checkpoint(record_, std::move(state));
    }
    void keep(const std::string& status) {
        save();
        folder_.write_manifest(record_, status, simulation_->snapshot());
    }

    const SceneFile& scene_;
    RunFolder folder_;
    std::unique_ptr<Simulation> simulation_;
    GuardedRun guarded_;
    RunRecord record_;
    std::size_t most_steps_;
    std::string json_;
};

}  // namespace

void run_scene(const SceneFile& scene, const RunOptions& options) { Run(scene, options).run(); }

}  // namespace reports
