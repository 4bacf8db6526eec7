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
#include "solver/kernels/wendland_c2.h"
#include "solver/scene/enforce_constraints.h"
#include "solver/scene/grid_passes.h"
#include "solver/scene/one_of.h"
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
    /// `pass` if the scene has walls.
    template <class Pass> Maybe<Pass> at_walls(Pass pass) const {
        if (file_.walls.empty()) return Skip{};
        return pass;
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
        return only_if(file_.no_slip && !file_.walls.empty(), GhostViscosity<W>{w_, file_.mu});
    }
    /// Each closed side of a tank is a plane without end, and so is a plane.
    EnforceConstraints<Dim> constraints() const {
        std::vector<Constraint<Dim>> all;
        const auto add = [&](const Vec<3>& point, const Vec<3>& n) {
            all.push_back({HalfSpace<Dim>{point.head<Dim>(), n.head<Dim>()}});
        };
        for (const Wall& wall : file_.walls) {
            if (wall.plane) add(wall.point, wall.normal);
            for (int d = 0; d < Dim && !wall.plane; ++d) {
                if (!wall.open[d][0]) add(wall.low, Vec<3>::Unit(d));
                if (!wall.open[d][1]) add(wall.high, -Vec<3>::Unit(d));
            }
        }
        for (const SolidConstraint& c : file_.constraints)
            all.push_back({shape_of<Dim>(c.shape), c.hollow, c.restitution, c.friction,
                           c.velocity.head<Dim>()});
        return {all};
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
    const SceneFile& file_;
    W w_;
};

}  // namespace plumbline
