#pragma once

#include "solver/fluid/pair_gradients.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

/// When an implicit solve ends, and how it goes there.
struct ProjectionLimits {
    double tolerance;        // of the mean error, a part of the rest density
    int least = 2;           // iterations at the least
    int most = 200;          // and at the most
    bool pulls = false;      // pressures may be negative: for fluids that fill their domain
    bool momentum = true;    // Nesterov's; without it the iteration is Jacobi's
    bool warm_start = true;  // begin with the pressures of the step before
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

/// ω, how far an iteration goes; the next solve begins with that of the last one.
struct ProjectionStep {
    double length = 1.0;
};

/// Memory of a solve, kept from step to step.
template <class Real, int Dim> struct ProjectionMemory {
    Points<Dim> start;
    std::vector<Real> P, v;  // v in fours, as lanes are gathered
    std::vector<double> rate, rate_before, P_before, next, last, excess;
};

/// The velocities nearest to those given (in Σ m v²) that no longer compress the fluid, found with
/// pressures that push and do not pull:
///   vᵢ ← vᵢ − Σⱼ mⱼ (Pᵢ + Pⱼ) ∇ᵢωᵢⱼ − 2 Pᵢ Σₖ mₖ ∇ᵢωᵢₖ,   P = Δt p/ρ² ≥ 0, ghosts k,
///   rᵢ = sourceᵢ + dρᵢ/dt(v) ≤ 0, and = 0 where Pᵢ > 0,
/// or with pressures of either sign and r = 0. The constraints of Bender and Koschier 2017; but where their iteration
/// only lets pressures grow, until nothing is compressed, here what was too much is taken back.
/// Iterations Pᵢ ← max(0, Yᵢ + ω αᵢ rᵢ(Y)) begin at Y, ahead of P by Nesterov's momentum, which is dropped where it leads
/// uphill (Beck and Teboulle 2009; O'Donoghue and Candès 2015): n layers of fluid take about n of them, and without it
/// n². They converge for ω λ ≤ 1, λ the largest eigenvalue of −α ∂r/∂P, about 2; the Rayleigh quotient of the last change
/// of Y, which for equal masses does not exceed it, shortens ω where it exceeds 1/ω.
/// Linear and angular momentum change by what ghosts give alone.
/// source(i) is in kg/(m^dim s), −infinity for a particle that takes no part. `scale` turns the mean of
/// the violated constraints, |r|, or what of it ω → ∞ could undo, into the error. v is changed; P holds the first guess,
/// and then what was found.
template <class Real, int Dim, class Source>
void project(const PairGradients<Real, Dim>& pairs, const ProjectionLimits& limits, double scale,
             Source source, std::vector<Vec<Dim>>& v, std::vector<double>& P, ProjectionStep& step,
             ProjectionMemory<Real, Dim>& memory, ProjectionReport& report) {
    const std::size_t n = v.size();
    const std::vector<double>& alpha = pairs.factors;
    ProjectionMemory<Real, Dim>& m = memory;
    m.start.assign(v.begin(), v.end());
    m.P.resize(n), m.v.resize(4 * n);
    for (auto* values : {&m.rate, &m.next, &m.excess}) values->resize(n);
    using Numbers = Lanes<Real>;
    const auto push = [&](Index i) -> Vec<Dim> {
        auto total = LaneVector<Real, Dim>::zero();
        const Numbers own = P[i];
        pairs.for_neighbours(
            i, [&](const Index* j, const auto& gradient) __attribute__((always_inline)) {
                total += (own + Numbers::gather(m.P.data(), j)) * gradient;
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
                gather_four(m.v.data(), 4, j, four);
                for_each_constant<Dim>(
                    [&](auto d) { total += (own.x[d] - four[d]) * gradient.x[d]; });
            });
        return sum(total) + v[i].dot(pairs.walls[i]) - pairs.flow_of_walls[i];
    };
    const auto takes_part = [&](std::size_t i) { return alpha[i] > 0.0 && m.rate[i] > -HUGE_VAL; };
    // Over those that take part, in one order, for sums that do not depend on threads.
    const auto sum_over = [&](auto term) {
        double total = 0.0;
        for (std::size_t i = 0; i < n; ++i)
            if (takes_part(i)) total += term(i);
        return total;
    };
    const double least = limits.pulls ? -HUGE_VAL : 0.0;
    double t = 1.0;  // Nesterov's
    m.last.assign(P.begin(), P.end());
    step.length = std::min(1.0, 1.02 * step.length);  // what shortened it may be over
    for (int iteration = 1;; ++iteration) {
        for (std::size_t i = 0; i < n; ++i) m.P[i] = static_cast<Real>(P[i]);
        parallel_for(n, [&](std::size_t i) {
            v[i] = m.start[i] - push(static_cast<Index>(i));
            for (std::size_t d = 0; d < Dim; ++d) m.v[4 * i + d] = static_cast<Real>(v[i][d]);
        });
        parallel_for(n, [&](std::size_t i) {
            m.rate[i] = source(i) + rate_of_density(static_cast<Index>(i));
        });
        if (iteration > 1) {
            const auto moved = [&](std::size_t i) { return P[i] - m.P_before[i]; };
            const double lowered =
                sum_over([&](std::size_t i) { return moved(i) * (m.rate_before[i] - m.rate[i]); });
            const double squares =
                sum_over([&](std::size_t i) { return moved(i) * moved(i) / alpha[i]; });
            if (step.length * lowered > squares) {
                step.length = 0.95 * squares / lowered;
                t = 1.0;
                m.last = P;
            }
        }
        m.P_before = P, m.rate_before = m.rate;
        parallel_for(n, [&](std::size_t i) {
            const double r = m.rate[i];
            if (!takes_part(i)) {
                m.next[i] = 0.0;
                m.excess[i] = r < 0.0 ? 0.0 : r;  // NaN is kept
                return;
            }
            m.next[i] = std::max(least, P[i] + step.length * alpha[i] * r);
            m.excess[i] = r < 0.0 ? std::min(-r, (P[i] - least) / alpha[i]) : r;
        });
        double error = 0.0;
        for (const double r : m.excess) error += r;
        error *= n == 0 ? 0.0 : scale / static_cast<double>(n);
        const bool good = error <= limits.tolerance;
        if ((good && iteration >= limits.least) || iteration >= limits.most)
            return report.add(iteration, error, good);
        const bool uphill = sum_over([&](std::size_t i) {
                                return (P[i] - m.next[i]) * (m.next[i] - m.last[i]) / alpha[i];
                            }) > 0.0;
        if (uphill || !limits.momentum) t = 1.0;
        const double t_next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
        const double ahead = limits.momentum ? (t - 1.0) / t_next : 0.0;
        t = t_next;
        for (std::size_t i = 0; i < n; ++i)
            P[i] = std::max(least, m.next[i] + ahead * (m.next[i] - m.last[i]));
        m.last.swap(m.next);
    }
}

}  // namespace plumbline
