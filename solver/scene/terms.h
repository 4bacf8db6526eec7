#pragma once

#include "solver/fluid/artificial_viscosity.h"
#include "solver/fluid/averaged_pressure_force.h"
#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/cohesion.h"
#include "solver/fluid/ghost_pressure_force.h"
#include "solver/fluid/ghost_viscosity.h"
#include "solver/fluid/monaghan_viscosity.h"
#include "solver/fluid/plain_pressure_force.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/scene/enforce_constraints.h"
#include "solver/scene/grid_passes.h"
#include "solver/scene/one_of.h"
#include "solver/scene/open_flow.h"
#include "solver/scene/scene_bodies.h"
#include "solver/scene/scene_file.h"
#include "solver/scene/start.h"
#include "solver/scene/time_step.h"

namespace plumbline {

/// The terms of a scene file that compositions share, as it chooses them.
template <int Dim, class K = WendlandC2<Dim>> class Terms {
public:
    using W = K;
    template <class Pass> using Maybe = OneOf<Skip, Pass>;

    explicit Terms(const SceneFile& file) : file_{file}, w_{file.support} {}

    const W& kernel() const { return w_; }
    /// `pass` if the scene has ghosts.
    template <class Pass> Maybe<Pass> at_walls(Pass pass) const {
        return only_if(has_ghosts(), std::move(pass));
    }
    template <class Pass> static Maybe<Pass> only_if(bool wanted, Pass pass) {
        if (!wanted) return Skip{};
        return pass;
    }

    using Pressures = OneOf<PressureForce<W>, AveragedPressureForce<W>, PlainPressureForce<W>>;
    Pressures pressure_force() const {
        if (file_.pressure_force == PressureForm::averaged) return AveragedPressureForce<W>{w_};
        if (file_.pressure_force == PressureForm::plain) return PlainPressureForce<W>{w_};
        return PressureForce<W>{w_};
    }
    using Viscosities =
        OneOf<Skip, ArtificialViscosity<W>, BrookshawViscosity<W>, MonaghanViscosity<W>>;
    Viscosities viscosity() const {
        switch (file_.viscosity) {
            case ViscosityForm::artificial:
                return ArtificialViscosity<W>{w_, file_.alpha, file_.speed_of_sound};
            case ViscosityForm::brookshaw:
                return BrookshawViscosity<W>{w_, file_.mu};
            case ViscosityForm::monaghan:
                return MonaghanViscosity<W>{w_, file_.mu};
            default:
                return Skip{};
        }
    }
    Maybe<GhostViscosity<W>> wall_viscosity() const {
        return only_if(file_.no_slip && has_ghosts(), GhostViscosity<W>{w_, file_.mu});
    }
    EnforceConstraints<Dim> constraints() const { return {solids_of<Dim>(file_)}; }
    /// `pass` if the scene has bodies.
    template <class Pass> Maybe<Pass> at_bodies(Pass pass) const {
        return only_if(!file_.bodies.empty(), std::move(pass));
    }
    Maybe<ViscosityOnBodies<W>> viscosity_on_bodies() const {
        return only_if(file_.no_slip && !file_.bodies.empty(), ViscosityOnBodies<W>{w_, file_.mu});
    }
    /// Throws InvalidInput as require_bodies_apart does.
    CollideBodies<Dim> contacts() const {
        CollideBodies<Dim> contacts = contacts_of<Dim>(file_);
        require_bodies_apart<Dim>(file_, contacts);
        return contacts;
    }
    BodyLimit<Dim> body_limit() const { return {contacts_of<Dim>(file_).outlines, file_.spacing}; }
    static OpenFlow<Dim> open_flow(const SceneFile& file) {
        OpenFlow<Dim> flow;
        for (const SceneEmitter& e : file.emitters)
            flow.emitters.push_back({.centre = e.centre.head<Dim>(),
                                     .direction = e.direction.head<Dim>(),
                                     .radius = e.radius,
                                     .speed = e.speed,
                                     .until = e.until.value_or(HUGE_VAL),
                                     .spacing = file.spacing,
                                     .mass = mass_of_particle<Dim>(file),
                                     .density = file.density});
        for (const SolidShape& shape : file.outflows) flow.outflows.push_back(shape_of<Dim>(shape));
        return flow;
    }
    template <class Hold> Maybe<Hold> hold_inflow() const {
        return only_if(!file_.emitters.empty(), Hold{open_flow(file_).emitters, file_.support});
    }
    Maybe<Cohesion<Dim>> cohesion() const {
        return only_if(file_.cohesion > 0.0,
                       Cohesion<Dim>{w_.support(), file_.density, file_.cohesion});
    }
    Vec<Dim> gravity() const { return file_.gravity.head<Dim>(); }

    AcousticLimit<Dim> acoustic_limit() const {
        return {TaitEquation(file_.density, file_.speed_of_sound, file_.exponent), w_.support()};
    }
    /// With the kinematic viscosity that the artificial one acts like, see ArtificialViscosity.
    ViscousLimit viscous_limit() const {
        const double artificial =
            file_.alpha * file_.speed_of_sound * 0.5 * w_.support() / (2.0 * (Dim + 2));
        const double fraction = file_.viscosity == ViscosityForm::monaghan ? 0.025 : 0.04;
        return {std::max(file_.mu / file_.density, artificial), w_.support(), fraction};
    }
    ForceLimit<Dim> force_limit() const { return {w_.support()}; }

private:
    bool has_ghosts() const { return !file_.walls.empty() || !file_.bodies.empty(); }

    const SceneFile& file_;
    W w_;
};

}  // namespace plumbline
