#pragma once

#include "solver/particles/body_centred.h"
#include "solver/particles/close_packed.h"
#include "solver/particles/clustered.h"
#include "solver/particles/graded.h"
#include "solver/particles/hexagonal.h"
#include "solver/particles/jittered.h"
#include "solver/particles/poisson_disc.h"

#include <string_view>

namespace plumbline {

/// A way to fill a box with about `count` points, for those who choose it by name. Those that are
/// not random use the seed for nothing, except halton, whose seed chooses where it begins.
template <int Dim> struct Sampling {
    std::string_view name;
    std::string_view says;
    Points<Dim> (*fill)(const Box<Dim>& box, Index count, std::uint64_t seed);
};

/// The edge of a cube (square) of the volume that each of `count` points has.
template <int Dim> double spacing_of(const Box<Dim>& box, Index count) {
    require_proper(box);
    return std::pow(box.volume() / require_count(count), 1.0 / Dim);
}

/// All samplings of dimension Dim. Lattices have as many points as whole cells fit, poisson_disc as
/// many as chance lets fit; the others exactly `count`.
template <int Dim> const std::vector<Sampling<Dim>>& samplings() {
    using B = Box<Dim>;
    using P = Points<Dim>;
    static const std::vector<Sampling<Dim>> all = [] {
        std::vector<Sampling<Dim>> list = {
            {"lattice", "square or cubic lattice",
             [](const B& b, Index n, std::uint64_t) -> P { return lattice(b, spacing_of(b, n)); }},
            {"jittered", "lattice, each coordinate moved by up to 0.3 spacings",
             [](const B& b, Index n, std::uint64_t seed) -> P {
                 return jittered(b, spacing_of(b, n), 0.3, seed);
             }},
            {"halton", "Halton sequence in bases 2, 3, 5",
             [](const B& b, Index n, std::uint64_t seed) -> P {
                 return halton(b, n, static_cast<Index>(1 + seed % 1000 * 1000));
             }},
            {"poisson_disc", "random, none too close, no gap left",
             [](const B& b, Index n, std::uint64_t seed) -> P {
                 constexpr double jammed[] = {0.7476, 0.6966, 0.7336};
                 return poisson_disc(b, std::pow(jammed[Dim - 1], 1.0 / Dim) * spacing_of(b, n),
                                     seed);
             }},
            {"uniform", "independent random points",
             [](const B& b, Index n, std::uint64_t seed) -> P {
                 return uniform_random(b, n, seed);
             }},
            {"graded", "Halton points, 100 times denser at one end",
             [](const B& b, Index n, std::uint64_t) -> P { return graded(b, n, 100.0); }},
            {"clustered", "8 clusters, 100 times denser than the rest",
             [](const B& b, Index n, std::uint64_t seed) -> P {
                 return clustered(b, n, {8, 0.1 * b.size().minCoeff(), 100.0}, seed);
             }}};
        if constexpr (Dim == 2)
            list.push_back(
                {"hexagonal", "hexagonal lattice", [](const B& b, Index n, std::uint64_t) -> P {
                     return hexagonal(b, std::sqrt(2.0 / std::sqrt(3.0)) * spacing_of(b, n));
                 }});
        if constexpr (Dim == 3) {
            list.push_back({"close_packed", "cubic close packed lattice",
                            [](const B& b, Index n, std::uint64_t) -> P {
                                return close_packed(b,
                                                    std::cbrt(std::sqrt(2.0)) * spacing_of(b, n));
                            }});
            list.push_back({"body_centred", "body centred cubic lattice",
                            [](const B& b, Index n, std::uint64_t) -> P {
                                return body_centred(
                                    b, std::cbrt(0.75 * std::sqrt(3.0)) * spacing_of(b, n));
                            }});
        }
        return list;
    }();
    return all;
}

/// Throws InvalidInput, naming those there are, if there is no sampling of that name.
template <int Dim> const Sampling<Dim>& sampling(std::string_view name) {
    std::string there;
    for (const Sampling<Dim>& s : samplings<Dim>()) {
        if (s.name == name) return s;
        there.append(" ").append(s.name);
    }
    throw InvalidInput("no sampling \"" + std::string(name) + "\" in " + std::to_string(Dim) +
                       "D; expected one of:" + there);
}

}  // namespace plumbline
