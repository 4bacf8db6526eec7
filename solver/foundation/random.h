#pragma once

#include <cstdint>
#include <random>

namespace plumbline {

/// Seeded random numbers, the same with every compiler and standard library: the engine is
/// specified bit for bit, the library's distributions are not, so they are not used.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_{seed} {}

    std::uint64_t bits() { return engine_(); }
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }  // [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

private:
    std::mt19937_64 engine_;
};

}  // namespace plumbline
