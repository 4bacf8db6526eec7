#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/scene/checkpoint.h"
#include "solver/scene/simulation.h"
#include "solver/scene/start.h"
#include "solver/scene/watched.h"

namespace plumbline {

/// A scene as a Simulation. Its passes report to `watch`, if they are Watched.
template <int Dim, class S> class Composed : public Simulation {
public:
    Composed(S scene, std::unique_ptr<Watch<Dim>> watch, Start<Dim> start)
        : scene_{std::move(scene)}, watch_{std::move(watch)} {
        get<Positions<Dim>>() = std::move(start.x);
        get<Velocities<Dim>>() = std::move(start.v);
        get<Masses>() = std::move(start.m);
        get<Density>() = std::move(start.rho);
        get<GhostPositions<Dim>>() = std::move(start.ghosts);
        get<GhostVelocities<Dim>>() = std::move(start.ghost_velocities);
        get<GhostMasses>() = std::move(start.ghost_masses);
    }

    void step(double dt) override { scene_.step(dt); }
    TimeStepLimits limits() const override { return scene_.template get<TimeStepLimits>(); }
    Snapshot snapshot() const override {
        return {Dim,
                numbers(scene_.template get<Positions<Dim>>()),
                numbers(scene_.template get<Velocities<Dim>>()),
                scene_.template get<Masses>(),
                scene_.template get<Density>(),
                scene_.template get<Pressure>(),
                numbers(scene_.template get<GhostPositions<Dim>>())};
    }
    void save(std::string& bytes) const override { save_state(scene_, bytes); }
    void load(std::string_view bytes) override { load_state(scene_, bytes); }

    Diagnosis step_watched(double dt, std::size_t particle) override {
        *watch_ = {.armed = true, .particle = particle};
        Diagnosis found;
        try {
            scene_.step(dt);
        } catch (const InvalidInput&) {  // a pass refused what an earlier one had spoilt
            if (!watch_->first_fault) throw;
        }
        watch_->armed = false;
        if (const auto& fault = watch_->first_fault) {
            found.fault_term = fault->term, found.fault_quantity = fault->quantity;
            found.fault_particle = fault->particle;
        }
        found.strongest_term = watch_->strongest_term;
        found.strongest = watch_->strongest;
        return found;
    }

private:
    template <class Q> Q& get() { return scene_.template get<Q>(); }
    static std::span<const double> numbers(const std::vector<Vec<Dim>>& vectors) {
        return {vectors.empty() ? nullptr : vectors[0].data(), vectors.size() * Dim};
    }

    S scene_;
    std::unique_ptr<Watch<Dim>> watch_;
};

/// `make(terms)` builds the scene; terms("name", pass) puts a pass under the watch.
template <int Dim, class Make>
std::unique_ptr<Simulation> composed(const SceneFile& file, Make make) {
    auto watch = std::make_unique<Watch<Dim>>();
    const auto terms = [w = watch.get()]<class Pass>(std::string_view name, Pass pass) {
        return Watched<Dim, Pass>{name, w, std::move(pass)};
    };
    auto scene = make(terms);
    auto simulation = std::make_unique<Composed<Dim, decltype(scene)>>(
        std::move(scene), std::move(watch), start_of<Dim>(file));
    const Diagnosis start = simulation->step_watched(0.0, 0);
    if (!start.fault_term.empty())
        throw InvalidInput(
            file.name + ": expected values with which the scene can begin, found that \"" +
            start.fault_quantity + "\" of particle " + std::to_string(start.fault_particle) +
            " is not finite after the term \"" + start.fault_term + "\"");
    return simulation;
}

/// By `SceneFile::method`, each in a file of its own.
std::unique_ptr<Simulation> make_sph_2d(const SceneFile& file);
std::unique_ptr<Simulation> make_sph_3d(const SceneFile& file);
std::unique_ptr<Simulation> make_dfsph_2d(const SceneFile& file);
std::unique_ptr<Simulation> make_dfsph_3d(const SceneFile& file);
std::unique_ptr<Simulation> make_delta_sph_2d(const SceneFile& file);
std::unique_ptr<Simulation> make_delta_sph_3d(const SceneFile& file);

}  // namespace plumbline
