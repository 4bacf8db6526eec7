#pragma once

#include "solver/neighbours/space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace plumbline {

/// Points that may be neighbours of the queries of one cell, one array per coordinate.
template <int Dim> class Candidates {
public:
    static constexpr std::size_t step = 64;

    /// Makes room for n candidates and a step more; the arrays only grow.
    void resize(std::size_t n) {
        size_ = n;
        const std::size_t room = words() * step + step;
        if (room <= id_.size()) return;
        for (auto& coordinate : x_) coordinate.resize(2 * room);
        id_.resize(2 * room);
    }
    /// Fills the last step with candidates at infinity, so that loops need no special last step.
    void close() {
        for (auto& coordinate : x_)
            std::fill_n(coordinate.begin() + static_cast<std::ptrdiff_t>(size_),
                        words() * step - size_, std::numeric_limits<double>::infinity());
    }
    std::size_t size() const { return size_; }
    /// How many words of 64 bits hold one bit for each candidate.
    std::size_t words() const { return (size_ + step - 1) / step; }

    double* x(int axis) { return x_[axis].data(); }
    const double* x(int axis) const { return x_[axis].data(); }
    Index* id() { return id_.data(); }
    const Index* id() const { return id_.data(); }

private:
    std::array<std::vector<double>, Dim> x_;
    std::vector<Index> id_;
    std::size_t size_ = 0;
};

/// Bit k of `within` says whether candidate k is closer to q than the radius, by the expression of
/// squared_distance; returns how many are. `within` has room for c.words() words.
template <class Space, int Dim>
std::size_t test_candidates(const Space& space, const Vec<Dim>& q, double squared_radius,
                            const Candidates<Dim>& c, std::uint64_t* within) {
    std::size_t found = 0;
    for (std::size_t w = 0; w < c.words(); ++w) {
        constexpr std::size_t step = Candidates<Dim>::step;
        std::array<double, step> squared;
        for (std::size_t k = 0; k < step; ++k) {
            const double d = space.difference(q[0], c.x(0)[w * step + k], 0);
            squared[k] = d * d;
        }
        for (int axis = 1; axis < Dim; ++axis)
            for (std::size_t k = 0; k < step; ++k) {
                const double d = space.difference(q[axis], c.x(axis)[w * step + k], axis);
                squared[k] += d * d;
            }
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < step; ++k)
            bits |= static_cast<std::uint64_t>(squared[k] < squared_radius) << k;
        within[w] = bits;
        found += static_cast<std::size_t>(std::popcount(bits));
    }
    return found;
}

/// Writes the ids of the candidates whose bits are set to `out`, which has room for 16 more; returns
/// how many they are.
inline std::size_t select_candidates(const Index* id, std::size_t words,
                                     const std::uint64_t* within, Index* out) {
    std::size_t found = 0;
    for (std::size_t w = 0; w < words; ++w)
        for (std::uint64_t bits = within[w]; bits != 0; bits &= bits - 1)
            out[found++] = id[w * 64 + static_cast<std::size_t>(std::countr_zero(bits))];
    return found;
}

}  // namespace plumbline
