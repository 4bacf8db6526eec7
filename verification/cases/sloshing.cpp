#include "verification/cases/sloshing.h"

#include "solver/foundation/errors.h"

#include <numbers>

namespace sloshing_signals {
namespace {
using namespace verification;
using namespace plumbline;

/// The line through the points by least squares: its slope.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) mean_x += x[k] / n, mean_y += y[k] / n;
    for (std::size_t k = 0; k < x.size(); ++k) {
        xx += (x[k] - mean_x) * (x[k] - mean_x);
        xy += (x[k] - mean_x) * (y[k] - mean_y);
    }
    return xy / xx;
}

/// ω and δ of a signal b(t) = b₀ exp(−δ t) cos ωt.
class Oscillation {
public:
    void add(double t, double b) {
        if (count_ > 0 && before_.b * b < 0.0) {
            zeros_.push_back(before_.t + (t - before_.t) * before_.b / (before_.b - b));
            numbers_.push_back(static_cast<double>(zeros_.size()));
            if (zeros_.size() > 1) times_.push_back(extreme_.t), logs_.push_back(extreme_.b);
            extreme_ = {t, -HUGE_VAL};
        }
        if (std::log(std::abs(b)) > extreme_.b) extreme_ = {t, std::log(std::abs(b))};
        before_ = {t, b};
        ++count_;
    }
    SloshingDecay fit() const {
        if (times_.size() < 2)
            throw InvalidInput("sloshing: expected at least 3 zeros of the mode, found " +
                               std::to_string(zeros_.size()));
        return {std::numbers::pi / slope_of(numbers_, zeros_), -slope_of(times_, logs_)};
    }

private:
    struct Sample {
        double t = 0.0, b = -HUGE_VAL;
    };
    int count_ = 0;
    Sample before_, extreme_;
    std::vector<double> zeros_, numbers_, times_, logs_;
};
}  // namespace
}  // namespace sloshing_signals

namespace verification {

using plumbline::Vec;

double sloshing_frequency(const WaterTank& tank) {
    const double k = std::numbers::pi / tank.tank.x();
    return std::sqrt(tank.gravity * k * std::tanh(k * tank.water.y()));
}

SloshingDecay sloshing_decay(WaterTank tank, double steepness, int periods) {
    const double k = std::numbers::pi / tank.tank.x(), omega = sloshing_frequency(tank);
    const auto mode = [k](const Vec<2>& x) {
        return Vec<2>(-std::sin(k * x.x()) * std::cosh(k * x.y()),
                      std::cos(k * x.x()) * std::sinh(k * x.y()));
    };
    const double speed = omega * steepness / k / std::sinh(k * tank.water.y());
    tank.velocity = [&](const Vec<2>& x) -> Vec<2> { return speed * mode(x); };
    sloshing_signals::Oscillation oscillation;
    simulate(tank, 2.0 * std::numbers::pi / omega * (periods + 0.3), [&](const WaterTankState& s) {
        double share = 0.0, whole = 0.0;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (s.wall[i] != 0) continue;
            const Vec<2> u = mode(s.x[i]);
            share += s.m[i] * s.v[i].dot(u), whole += s.m[i] * u.squaredNorm();
        }
        oscillation.add(s.time, share / whole);
    });
    return oscillation.fit();
}

Elevation swayed_elevation(const WaterTank& tank, double from_wall, double duration) {
    Elevation elevation;
    const double half = std::min(tank.spacing, from_wall);
    simulate(tank, duration, [&](const WaterTankState& s) {
        elevation.t.push_back(s.time);
        elevation.height.push_back(
            height_between(s, tank.rest_density, from_wall - half, from_wall + half) -
            tank.water.y());
    });
    return elevation;
}

double linear_elevation(const WaterTank& tank, double from_wall, double t, int modes) {
    const double omega = 2.0 * std::numbers::pi / tank.period;
    double height = 0.0;
    for (int n = 1; n < modes; n += 2) {
        const double k = n * std::numbers::pi / tank.tank.x();
        const double own = std::sqrt(tank.gravity * k * std::tanh(k * tank.water.y()));
        // x − L/2 = −Σ 4/(L k²) cos kx, and at rest in a steady frame η = −Ẍ/g (x − L/2).
        const double steady =
            -tank.sway * omega * omega / tank.gravity * 4.0 / (tank.tank.x() * k * k);
        height += steady * own * own * (std::cos(omega * t) - std::cos(own * t)) /
                  (own * own - omega * omega) * std::cos(k * from_wall);
    }
    return height;
}

}  // namespace verification
