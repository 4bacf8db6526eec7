#pragma once

namespace reports {

/// How far two measurements of the same work differ on this machine, now: no comparison of times can
/// tell less.
struct NoiseFloor {
    double
        relative;   // largest |A / B - 1| of the medians of A and B, the same work, over the rounds
    double spread;  // median absolute deviation of one run, relative to the median
    double seconds;    // median of one run [s]
    int rounds, runs;  // rounds, each of `runs` A and `runs` B, interleaved A B A B
};

/// Takes well below a second.
NoiseFloor measure_noise_floor();

}  // namespace reports
