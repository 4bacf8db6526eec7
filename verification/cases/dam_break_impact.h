#pragma once

#include "verification/cases/water_tank.h"

namespace verification {

/// Lobovsky et al. 2014, H = 0.3 m: a column of water 2 H long runs into the end wall of its tank, 1.61 m long. Times are
/// t √(g/H), from the release; pressures over ρ g H.
WaterTank lobovsky_tank(int particles_per_height);

/// The mean pressure over the face of a sensor in a vertical wall, a disc: ∫ p(z) 2 √(r² − (z − z₀)²) dz over its area,
/// p = max(0, FluidNearWalls::pressure), as particles of the wall there would have it, by Chebyshev's rule of the second kind with 3 nodes.
class WallSensor {
public:
    WallSensor(double wall, double height, double diameter);
    /// Weights of its nodes; places of them in the wall.
    static constexpr int nodes = 3;
    const std::array<plumbline::Vec<2>, nodes>& places() const { return places_; }
    static const std::array<double, nodes>& weights();

private:
    std::array<plumbline::Vec<2>, nodes> places_;
};

/// The pressures of sensors [Pa].
class WallSensors {
public:
    WallSensors(const WaterTank& tank, std::vector<WallSensor> sensors);
    std::vector<double> read(const WaterTankState& state);

private:
    plumbline::WendlandC2<2> w_;
    std::vector<WallSensor> sensors_;
    plumbline::Points<2> places_;
    plumbline::FluidNearWalls<2> near_;
};

/// What the sensors of the end wall and the front did, at the times k · interval.
struct Impact {
    static constexpr double interval = 0.005;  // of t √(g/H): that of the published medians
    std::vector<double> t;
    std::array<std::vector<double>, 4> pressure;  // the mean over the interval around t
    std::vector<double> front;                    // from the gate, over H
};
Impact impact_of(const WaterTank& tank, double until);

}  // namespace verification
