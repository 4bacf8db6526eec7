#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// The plane ⟨n, x − point⟩ = 0 with n of length 1, pointing into the fluid, and the velocity of the wall behind it.
template <int Dim> struct MirrorPlane {
    Vec<Dim> point;  // [m]
    Vec<Dim> n;
    Vec<Dim> velocity = Vec<Dim>::Zero();  // of the wall [m/s]
    bool slip = true;
};

/// Every particle nearer to a plane than `reach`, the support, has a ghost in its mirror image, of its mass: fluid
/// behind the wall that moves against the fluid before it. With slip its velocity is mirrored; without, the mean of
/// particle and ghost is the velocity of the wall, so that fluid at the wall sticks to it. Exact for planes, to the order
/// of the sums themselves, where ghosts of fixed velocity are of order 1.
/// Before ghosts are looked for; no other ghosts are kept. Where two planes meet, images of images are left out:
/// a corner lacks the fluid behind it.                          adams2009 Sec. 6.3; Morris et al. 1997
template <int Dim> struct MirrorGhosts {
    using Reads = Quantities<Positions<Dim>, Velocities<Dim>, Masses>;
    using Writes = Quantities<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses>;
    std::vector<MirrorPlane<Dim>> planes;
    double reach;  // [m]

    void run(double, const Positions<Dim>& x, const Velocities<Dim>& v, const Masses& m,
             GhostPositions<Dim>& ghosts, GhostVelocities<Dim>& v_ghost,
             GhostMasses& m_ghost) const {
        ghosts.clear(), v_ghost.clear(), m_ghost.clear();
        for (const MirrorPlane<Dim>& plane : planes)
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double distance = plane.n.dot(x[i] - plane.point);
                if (!(distance >= 0.0 && distance < reach)) continue;
                const Vec<Dim> relative = v[i] - plane.velocity;
                const Vec<Dim> mirrored =
                    plane.slip ? Vec<Dim>(relative - 2.0 * plane.n.dot(relative) * plane.n)
                               : Vec<Dim>(-relative);
                ghosts.push_back(x[i] - 2.0 * distance * plane.n);
                v_ghost.push_back(plane.velocity + mirrored);
                m_ghost.push_back(m[i]);
            }
    }
};

}  // namespace plumbline
