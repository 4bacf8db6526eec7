#include "solver/scene/guarded_run.h"

#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace guarded_run_test {
namespace {
using namespace plumbline;
using namespace verification;

SceneFile scene(const std::string& from, const std::string& to,
                const std::string& method = "delta_sph", int dim = 2) {
    return SceneFile::parse("s.toml", with(dam_break_scene(dim, method, 1.0), from, to));
}

/// Runs until it fails; the message. `at_failure` sees the simulation and the run afterwards.
template <class Look> std::string failure(const SceneFile& file, Look at_failure) {
    const auto simulation = make_simulation(file);
    GuardedRun run(*simulation, domain_of(file, simulation->snapshot()));
    try {
        for (int n = 0; n < 2000; ++n)
            run.step(next_step(file, simulation->limits(), run.time(), file.end));
    } catch (const SimulationFailed& e) {
        at_failure(*simulation, run);
        return e.what();
    }
    return "none";
}

TEST_CASE("a step that is too long ends with particle, term and time, in the last good state") {
    for (const int dim : {2, 3})
        for (const std::string method : {"delta_sph", "sph"}) {
            const std::string message =
                failure(scene("[time]", "[time]\nstep = 0.02", method, dim),
                        [](const Simulation& simulation, const GuardedRun& run) {
                            const Snapshot s = simulation.snapshot();
                            for (const double x : s.x) CHECK(std::isfinite(x));
                            CHECK(run.time() == Approx(0.02 * static_cast<double>(run.steps())));
                        });
            INFO(message);
            CHECK(message.find("particle ") == 0);
            CHECK(message.find(" at t = ") != std::string::npos);
            CHECK(message.find("the term ") != std::string::npos);
        }
}

TEST_CASE("what leaves the domain is named, and the state is the one before that step") {
    // Nothing holds the fluid: it falls out of its domain.
    std::string text = dam_break_scene(2, "delta_sph", 1.0);
    const std::size_t wall = text.find("[[wall]]"), time = text.find("[time]");
    text =
        text.substr(0, wall) + "[domain]\nlow = [-1, -0.05]\nhigh = [2, 1]\n" + text.substr(time);
    const std::string message = failure(SceneFile::parse("s.toml", text),
                                        [](const Simulation& simulation, const GuardedRun&) {
                                            for (const double x : simulation.snapshot().x)
                                                CHECK(x >= -1.0);
                                            const Snapshot s = simulation.snapshot();
                                            for (std::size_t i = 0; i < s.size(); ++i)
                                                CHECK(s.coordinate(i, 1) >= -0.05);
                                        });
    INFO(message);
    CHECK(message.find("left the domain at t = 0.1") != std::string::npos);
    CHECK(message.find("m; the term that accelerated it most, by ") != std::string::npos);
}

TEST_CASE("the first term with a number that is not finite is named") {
    for (const char* method : {"delta_sph", "sph"}) {
        const std::string text = with(
            with(dam_break_scene(2, method, 1.0), "end = 1.000000", "step = 1e200\nend = 1e201"),
            "interval = 0.02", "interval = 1e200");
        const std::string message = failure(SceneFile::parse("s.toml", text), [](auto&, auto&) {});
        INFO(message);
        CHECK(message.find("particle 0: \"positions\" is not finite at t = 1e+200 s (step 1)") ==
              0);
        CHECK(message.find("after the term \"time step\"") != std::string::npos);
    }
}

TEST_CASE("limits that vanish end a run") {
    CHECK(failure(scene("speed_of_sound = 30", "speed_of_sound = 1e100"), [](auto&, auto&) {
          }).find("the time step fell to ") == 0);
}

TEST_CASE("a scene that cannot begin is refused, with particle and term") {
    CHECK_THROWS_WITH(make_simulation(scene("speed_of_sound = 30", "speed_of_sound = 1e160")),
                      Catch::Contains("\"pressure\" of particle 0 is not finite after the term "
                                      "\"pressure\""));
}

TEST_CASE("steps reach an event exactly, and leave no crumb") {
    SceneFile file = scene("", "");
    TimeStepLimits limits;
    limits.acoustic = 0.3;
    CHECK(next_step(file, limits, 0.0, 1.0).dt == 0.3);
    CHECK(next_step(file, limits, 0.0, 1.0).why == "acoustic");
    CHECK(next_step(file, limits, 0.9, 1.0).why == "output");
    CHECK(next_step(file, limits, 0.9, 1.0).end == 1.0);
    CHECK(next_step(file, limits, 0.7 + 1e-13, 1.0).dt == 0.3);
    CHECK(next_step(file, limits, 0.7 - 1e-13, 1.0).end == 1.0);
    CHECK(next_step(file, limits, 0.5, 1.0).dt == 0.25);
    CHECK(next_step(file, limits, 0.5, 1.0).why == "output");
    file.largest_step = 0.1;
    CHECK(next_step(file, limits, 0.0, 1.0).why == "largest");
    file.largest_step.reset();
    file.step = 0.2;
    CHECK(next_step(file, limits, 0.0, 1.0).why == "fixed");
    limits.acoustic = NAN;
    file.step.reset();
    CHECK_THROWS_AS(next_step(file, limits, 0.0, 1.0), SimulationFailed);
}
}  // namespace
}  // namespace guarded_run_test
