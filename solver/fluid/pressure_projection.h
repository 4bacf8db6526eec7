#pragma once

#include "solver/fluid/pair_gradients.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

/// When an implicit solve ends, and how it goes there.
struct ProjectionLimits {
    double tolerance;         // of the mean error, a part of the rest density
    int least = 2;            // iterations at the least
    int most = 200;           // and at the most
    double relaxation = 0.5;  // ω of Jacobi's iteration
    bool warm_start = true;   // begin with the pressures of the step before
};

/// What the last solve did, and all of them together. `error` is that of the velocities as they were
/// left, also where the iterations did not suffice.
struct ProjectionReport {
    int iterations = 0;
    double error = 0.0;
    bool converged = true;
    int solves = 0, failures = 0, all_iterations = 0;

    void add(int n, double e, bool good) {
        iterations = n, error = e, converged = good;
        ++solves, all_iterations += n, failures += good ? 0 : 1;
    }
};

/// Memory of a solve, kept from step to step.
template <class Real, int Dim> struct ProjectionMemory {
    Points<Dim> start;
    std::vector<Real> P, v;  // v in fours, as lanes are gathered
    std::vector<double> next, excess;
};

/// The velocities nearest to those given (in Σ m v²) that no longer compress the fluid, found with
/// pressures that push and do not pull:
///   vᵢ ← vᵢ − Σⱼ mⱼ (Pᵢ + Pⱼ) ∇ᵢωᵢⱼ − Pᵢ Σₖ mₖ ∇ᵢωᵢₖ,   P = Δt p/ρ² ≥ 0, ghosts k,
///   rᵢ = sourceᵢ + dρᵢ/dt(v) ≤ 0, and = 0 where Pᵢ > 0,
/// by the projected Jacobi iteration Pᵢ ← max(0, Pᵢ + ω αᵢ rᵢ).
/// Linear and angular momentum change by what ghosts give alone. After Bender and Koschier 2017, whose
/// iteration lets pressures only grow; this one also takes back what was too much.
/// source(i) is in kg/(m^dim s), −infinity for a particle that takes no part. `scale` turns the mean of
/// max(0, r) into the error. v is changed; P holds the first guess, and then what was found.
template <class Real, int Dim, class Source>
void project(const PairGradients<Real, Dim>& pairs, const ProjectionLimits& limits, double scale,
             Source source, std::vector<Vec<Dim>>& v, std::vector<double>& P,
             ProjectionMemory<Real, Dim>& memory, ProjectionReport& report) {
    const std::size_t n = v.size();
    memory.start.assign(v.begin(), v.end());
    memory.P.resize(n), memory.v.resize(4 * n), memory.next.resize(n), memory.excess.resize(n);
    using Numbers = Lanes<Real>;
    const auto push = [&](Index i) -> Vec<Dim> {
        auto total = LaneVector<Real, Dim>::zero();
        const Numbers own = P[i];
        pairs.for_neighbours(
            i, [&](const Index* j, const auto& gradient) __attribute__((always_inline)) {
                total += (own + Numbers::gather(memory.P.data(), j)) * gradient;
            });
        return sum(total) + P[i] * pairs.walls[i];
    };
    const auto rate_of_density = [&](Index i) -> double {
        Numbers total = 0.0;
        LaneVector<Real, Dim> own;
        for (int d = 0; d < Dim; ++d) own.x[d] = v[i][d];
        pairs.for_neighbours(
            i, [&](const Index* j, const auto& gradient) __attribute__((always_inline)) {
                Numbers four[4];
                gather_four(memory.v.data(), 4, j, four);
                for_each_constant<Dim>(
                    [&](auto d) { total += (own.x[d] - four[d]) * gradient.x[d]; });
            });
        return sum(total) + v[i].dot(pairs.walls[i]) - pairs.flow_of_walls[i];
    };
    for (int iteration = 1;; ++iteration) {
        for (std::size_t i = 0; i < n; ++i) memory.P[i] = static_cast<Real>(P[i]);
        parallel_for(n, [&](std::size_t i) {
            v[i] = memory.start[i] - push(static_cast<Index>(i));
            for (std::size_t d = 0; d < Dim; ++d) memory.v[4 * i + d] = static_cast<Real>(v[i][d]);
        });
        parallel_for(n, [&](std::size_t i) {
            const double r = source(i) + rate_of_density(static_cast<Index>(i));
            memory.excess[i] = r < 0.0 ? 0.0 : r;  // NaN is kept
            memory.next[i] = std::max(0.0, P[i] + limits.relaxation * pairs.factors[i] * r);
        });
        double error = 0.0;
        for (const double r : memory.excess) error += r;
        error *= n == 0 ? 0.0 : scale / static_cast<double>(n);
        const bool good = error <= limits.tolerance;
        if ((good && iteration >= limits.least) || iteration >= limits.most)
            return report.add(iteration, error, good);
        P.swap(memory.next);
    }
}

}  // namespace plumbline
