#pragma once

#include "verification/fluid/drop.h"
#include "verification/framework/claim.h"

#include <string>

namespace verification {

/// The same drop in a frame that moves by (30, -20, 10): the accelerations must not tell.
template <int Dim> Drop<Dim> moving(Drop<Dim> drop) {
    const pl::Vec<Dim> u = pl::Vec<3>(30.0, -20.0, 10.0).head<Dim>();
    for (auto& v : drop.v) v += u;
    return drop;
}
/// The drop in rigid motion: v = u + ω × x.
template <int Dim> Drop<Dim> spinning(Drop<Dim> drop) {
    for (std::size_t i = 0; i < drop.x.size(); ++i) {
        const pl::Vec<3> turned = pl::Vec<3>(0.0, 0.0, 2.0).cross(in_space<Dim>(drop.x[i]));
        drop.v[i] = turned.template head<Dim>() + pl::Vec<Dim>::Constant(0.7);
    }
    return drop;
}

template <int Dim, class... Passes> double net_force_of(Passes... passes) {
    return net_force<Dim>(evaluated<Dim>(Drop<Dim>{}, passes...));
}
template <int Dim, class... Passes> double net_torque_of(Passes... passes) {
    return net_torque<Dim>(evaluated<Dim>(Drop<Dim>{}, passes...));
}
template <int Dim, class... Passes> double power_of(Passes... passes) {
    return power<Dim>(evaluated<Dim>(Drop<Dim>{}, passes...));
}
/// max ‖a′ − a‖ / max ‖a‖, a′ in the moving frame.
template <int Dim, class... Passes> double change_in_moving_frame(Passes... passes) {
    const Drop<Dim> drop;
    const auto at_rest = evaluated<Dim>(drop, passes...);
    const auto moves = evaluated<Dim>(moving(drop), passes...);
    return largest_difference<Dim>(moves.template get<pl::Accelerations<Dim>>(),
                                   at_rest.template get<pl::Accelerations<Dim>>());
}
/// max ‖a‖ of a rigid motion / max ‖a‖ of random velocities of the same size.
template <int Dim, class... Passes> double braking_of_rigid_motion(Passes... passes) {
    const Drop<Dim> drop;
    const auto rigid = evaluated<Dim>(spinning(drop), passes...);
    const auto random = evaluated<Dim>(drop, passes...);
    double largest = 0.0, size = 0.0;
    for (const auto& a : rigid.template get<pl::Accelerations<Dim>>())
        largest = std::max(largest, a.norm());
    for (const auto& a : random.template get<pl::Accelerations<Dim>>())
        size = std::max(size, a.norm());
    return largest / size;
}

inline Claim linear_momentum(const std::string& force, Source source,
                             std::function<double()> measure, std::function<double()> sabotaged,
                             std::optional<int> erratum = {}) {
    return {.id = force + ".conserves_linear_momentum",
            .source = source,
            .says = "‖Σ mᵢ aᵢ‖ = 0 for irregular particles of unequal masses",
            .bound = at_most(rounding_of_pairs, sums_of_pairs),
            .measure = std::move(measure),
            .sabotaged = std::move(sabotaged),
            .erratum = erratum};
}
inline Claim angular_momentum(const std::string& force, Source source,
                              std::function<double()> measure, std::function<double()> sabotaged,
                              std::optional<int> erratum = {}) {
    return {.id = force + ".conserves_angular_momentum",
            .source = source,
            .says = "‖Σ xᵢ × mᵢ aᵢ‖ = 0: forces act along the lines between particles",
            .bound = at_most(rounding_of_pairs, sums_of_pairs),
            .measure = std::move(measure),
            .sabotaged = std::move(sabotaged),
            .erratum = erratum};
}
inline Claim galilean(const std::string& force, Source source, std::function<double()> measure,
                      std::function<double()> sabotaged) {
    return {.id = force + ".is_galilean",
            .source = source,
            .says =
                "the accelerations are the same in a frame that moves 40 times faster than the "
                "particles",
            .bound = at_most(2e-13,
                             "velocities up to 40 are rounded to 3.6e-15, so that "
                             "differences of size 1 are off by 7e-15; 20 such terms"),
            .measure = std::move(measure),
            .sabotaged = std::move(sabotaged)};
}
inline Claim dissipative(const std::string& force, Source source, std::function<double()> measure,
                         std::function<double()> sabotaged, std::optional<int> erratum = {}) {
    return {.id = force + ".only_takes_energy",
            .source = source,
            .says = "Σ mᵢ aᵢ·vᵢ < 0 for random velocities",
            .bound = at_most(0.0, "each pair gives − coefficient · (square), coefficient ≥ 0"),
            .measure = std::move(measure),
            .sabotaged = std::move(sabotaged),
            .erratum = erratum};
}

}  // namespace verification
