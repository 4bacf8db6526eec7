#include "verification/cases/dam_break_impact.h"

#include <numbers>

namespace verification {

using plumbline::Index;

WaterTank lobovsky_tank(int particles_per_height) {
    return {.tank = {1.61, 0.6}, .water = {0.6, 0.3}, .spacing = 0.3 / particles_per_height};
}

WallSensor::WallSensor(double wall, double height, double diameter) {
    for (int k = 0; k < nodes; ++k)
        places_[static_cast<std::size_t>(k)] = {
            wall, height - 0.5 * diameter * std::cos((k + 1) * std::numbers::pi / (nodes + 1))};
}
// sin² of kπ/4, over their sum.
const std::array<double, WallSensor::nodes>& WallSensor::weights() {
    static const std::array<double, nodes> all{0.25, 0.5, 0.25};
    return all;
}

WallSensors::WallSensors(const WaterTank& tank, std::vector<WallSensor> sensors)
    : w_{tank.kernel()}, sensors_{std::move(sensors)} {
    for (const WallSensor& sensor : sensors_)
        places_.insert(places_.end(), sensor.places().begin(), sensor.places().end());
}
std::vector<double> WallSensors::read(const WaterTankState& state) {
    near_.find(state.x, state.wall, places_, w_.support());
    std::vector<double> pressures;
    Index node = 0;
    for ([[maybe_unused]] const WallSensor& sensor : sensors_) {
        double mean = 0.0;
        for (const double weight : WallSensor::weights()) {
            const double p =
                near_.pressure(node, places_[node], w_, state.gravity, state.rho, state.p);
            mean += weight * std::max(0.0, p);
            ++node;
        }
        pressures.push_back(mean);
    }
    return pressures;
}

Impact impact_of(const WaterTank& tank, double until) {
    const double H = tank.water.y(), unit = std::sqrt(H / tank.gravity);
    const double wall = tank.tank.x(), diameter = 4.2e-3;
    WallSensors sensors(tank, {{wall, 3e-3, diameter},
                               {wall, 15e-3, diameter},
                               {wall, 30e-3, diameter},
                               {wall, 80e-3, diameter}});
    const auto samples = static_cast<std::size_t>(std::lround(until / Impact::interval)) + 1;
    Impact impact;
    for (std::size_t k = 0; k < samples; ++k)
        impact.t.push_back(static_cast<double>(k) * Impact::interval);
    impact.front.assign(samples, 0.0);
    for (auto& p : impact.pressure) p.assign(samples, 0.0);
    std::vector<int> count(samples, 0);
    const auto add = [&](const WaterTankState& state) {
        const auto k = static_cast<std::size_t>(std::lround(state.time / unit / Impact::interval));
        if (k >= samples) return;
        const double n = ++count[k];
        // Half a spacing of water is ahead of the foremost particle.
        const double front =
            (std::min(largest_x(state) + 0.5 * tank.spacing, wall) - tank.water.x()) / H;
        impact.front[k] += (front - impact.front[k]) / n;
        const std::vector<double> p = sensors.read(state);
        for (std::size_t s = 0; s < p.size(); ++s) {
            double& mean = impact.pressure[s][k];
            mean += (p[s] / (tank.rest_density * tank.gravity * H) - mean) / n;
        }
    };
    simulate(tank, (until + 0.5 * Impact::interval) * unit, add);
    return impact;
}

}  // namespace verification
