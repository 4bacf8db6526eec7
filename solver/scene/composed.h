#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/scene/checkpoint.h"
#include "solver/scene/simulation.h"
#include "solver/scene/start.h"
#include "solver/scene/terms.h"
#include "solver/scene/watched.h"

namespace plumbline {

template <int Dim> BodyState state_of(const RigidBody<Dim>& body) {
    const auto in_space = [](const Vec<Dim>& v) {
        Vec<3> all = Vec<3>::Zero();
        all.template head<Dim>() = v;
        return all;
    };
    const auto about_z = [](const Turn<Dim>& t) {
        Vec<3> all = Vec<3>::Zero();
        all.template tail<turns<Dim>>() = t;
        return all;
    };
    Mat<3> rotation = Mat<3>::Identity();
    rotation.topLeftCorner<Dim, Dim>() = body.rotation;
    const Eigen::AngleAxisd turn(rotation);
    return {in_space(body.centre),
            turn.angle() * turn.axis(),
            in_space(body.velocity),
            about_z(body.spin),
            in_space(body.force),
            about_z(body.torque),
            body.mass};
}

/// A scene as a Simulation. Its passes report to `watch`, if they are Watched.
template <int Dim, class S> class Composed : public Simulation {
public:
    Composed(S scene, std::unique_ptr<Watch<Dim>> watch, Start<Dim> start, OpenFlow<Dim> flow)
        : scene_{std::move(scene)}, watch_{std::move(watch)}, flow_{std::move(flow)} {
        get<EmitterStates>().resize(flow_.emitters.size());
        get<OutflowStates>().resize(flow_.outflows.size());
        get<Positions<Dim>>() = std::move(start.x);
        get<Velocities<Dim>>() = std::move(start.v);
        get<Masses>() = std::move(start.m);
        get<Density>() = std::move(start.rho);
        get<GhostPositions<Dim>>() = std::move(start.ghosts);
        get<GhostVelocities<Dim>>() = std::move(start.ghost_velocities);
        get<GhostMasses>() = std::move(start.ghost_masses);
        if constexpr (has_bodies) {
            get<RigidBodies<Dim>>() = std::move(start.bodies);
            get<BodyOfGhost>() = std::move(start.body_of_ghost);
            get<PlaceInBody<Dim>>() = std::move(start.places);
        }
    }

    void step(double dt) override {
        let_in_and_out();
        scene_.step(dt);
        for (EmitterState& state : get<EmitterStates>()) state.time += dt;
    }
    TimeStepLimits limits() const override { return scene_.template get<TimeStepLimits>(); }
    Snapshot snapshot() const override {
        Snapshot all{Dim,
                     numbers(scene_.template get<Positions<Dim>>()),
                     numbers(scene_.template get<Velocities<Dim>>()),
                     scene_.template get<Masses>(),
                     scene_.template get<Density>(),
                     scene_.template get<Pressure>(),
                     numbers(scene_.template get<GhostPositions<Dim>>()),
                     numbers(scene_.template get<GhostVelocities<Dim>>())};
        if constexpr (has_bodies) {
            all.body_of_ghost = scene_.template get<BodyOfGhost>();
            for (const RigidBody<Dim>& body : scene_.template get<RigidBodies<Dim>>())
                all.bodies.push_back(state_of(body));
        }
        for (const EmitterState& state : scene_.template get<EmitterStates>()) {
            all.emitted.particles += state.particles, all.emitted.mass += state.mass;
            all.emitted.blocked += state.blocked;
        }
        for (const OutflowState& state : scene_.template get<OutflowStates>())
            all.removed.particles += state.particles, all.removed.mass += state.mass;
        return all;
    }
    void save(std::string& bytes) const override { save_state(scene_, bytes); }
    void load(std::string_view bytes) override { load_state(scene_, bytes); }

    Diagnosis step_watched(double dt, std::size_t particle) override {
        *watch_ = {.armed = true, .particle = particle};
        Diagnosis found;
        try {
            step(dt);
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
    static constexpr bool has_bodies = S::template stores<RigidBodies<Dim>>;

    template <class Q> Q& get() { return scene_.template get<Q>(); }
    static std::span<const double> numbers(const std::vector<Vec<Dim>>& vectors) {
        return {vectors.empty() ? nullptr : vectors[0].data(), vectors.size() * Dim};
    }

    void let_in_and_out() {
        const auto stay = flow_.staying(get<Positions<Dim>>(), get<Masses>(), get<OutflowStates>());
        if (stay) scene_.reorder(*stay);
        flow_.emit(get<Positions<Dim>>(), get<Velocities<Dim>>(), get<Masses>(), get<Density>(),
                   get<EmitterStates>());
    }

    S scene_;
    std::unique_ptr<Watch<Dim>> watch_;
    OpenFlow<Dim> flow_;
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
        std::move(scene), std::move(watch), start_of<Dim>(file), Terms<Dim>::open_flow(file));
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
