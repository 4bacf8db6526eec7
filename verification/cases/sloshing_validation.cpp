#include "verification/cases/sloshing.h"
#include "verification/framework/validation.h"
#include "verification/reference_data/reference.h"

namespace sloshing_validation {
namespace {
using namespace verification;

constexpr const char* scheme =
    "weakly compressible in the plane, c₀ = 10 √(g H), Wendland C2 of support 4 spacings, "
    "artificial "
    "viscosity 0.02, density diffusion 0.1, walls with the pressure of the fluid (Adami et al. "
    "2012), "
    "particles at random by 0.1 spacings";

/// Bäuerlein and Avila 2021, by its rows: δ and ω measured.
Validation decay() {
    const Reference table("bauerlein_avila_2021_sloshing_decay");
    const auto& value = table["value"];
    const auto& uncertainty = table["uncertainty"];
    return {
        .id = "sloshing_decay",
        .source = {Paper::literature, "Bäuerlein and Avila 2021"},
        .says =
            "Water 0.4 m deep in a tank 0.5 m long and 0.05 m wide swings in its first mode and "
            "dies "
            "down; potential theory has ω = 7.80 1/s, laminar boundary layers (Keulegan) δ = "
            "0.0434 "
            "1/s. These, √(2ν/ω) = 0.5 mm thick, are not resolved: the simulated decay is that of "
            "layers of the artificial viscosity α c h/8, and falls as slowly as the square root of "
            "the spacing. Where it crosses the measured one it says nothing about friction; ω can "
            "be trusted, and δ only as a bound on what a scheme adds",
        .what_is_run = std::string(scheme) + "; steepness 0.1, 4 periods",
        .spacing = {0.4 / 12, 0.4 / 16, 0.4 / 20, 0.4 / 40, 0.4 / 80, 0.4 / 160},
        .quantities =
            {{.name = "ω",
              .unit = "1/s",
              .measured = value[1],
              .u_data = uncertainty[1],
              .u_input = 0.01,
              .why = "as published; the tank's length to 0.5 mm is 0.1 % of k, the steepness "
                     "0.1 takes 0.1²/8 of ω"},
             {.name = "δ",
              .unit = "1/s",
              .measured = value[0],
              .u_data = uncertainty[0],
              .u_input = 0.002,
              .why = "as published; ν to 10 %, from 5 K, is 5 % of what Keulegan has"}},
        .panels = {},
        .observe =
            [](double spacing) {
                const SloshingDecay d = sloshing_decay(
                    {.tank = {0.5, 0.6}, .water = {0.5, 0.4}, .spacing = spacing, .sound = 10.0},
                    0.1, 4);
                return Validation::Observation{{d.frequency, d.decay}, {}};
            },
        .tags = {"sloshing"}};
}

/// The four crests of the two packets of waves, between these times [s].
constexpr std::array<std::array<double, 2>, 4> crests{
    {{2.0, 3.2}, {3.4, 4.7}, {7.1, 8.3}, {8.5, 9.8}}};

struct Crest {
    double time, height;
};
Crest highest(const Curve& eta, const std::array<double, 2>& between) {
    Crest crest{NAN, -HUGE_VAL};
    for (std::size_t k = 0; k < eta.x.size(); ++k)
        if (eta.x[k] > between[0] && eta.x[k] < between[1] && eta.y[k] > crest.height)
            crest = {eta.x[k], eta.y[k]};
    return crest;
}
double mean_crest(const Curve& eta) {
    double sum = 0.0;
    for (const auto& when : crests) sum += highest(eta, when).height;
    return sum / crests.size();
}
double lowest(const Curve& eta) { return *std::ranges::min_element(eta.y); }

Validation sway() {
    const Reference table("faltinsen_2000_sloshing_elevation");
    const Curve measured{table["t"], table["eta"]};
    constexpr double line = 0.005, instant = 0.02;
    return {
        .id = "sloshing_sway",
        .source = {Paper::literature, "Faltinsen et al. 2000, Fig. 7"},
        .says =
            "A tank of 1.73 m with water 0.6 m deep sways by 0.032 m with a period of 1.3 s, from "
            "rest; elevation 0.05 m off its left wall: waves of the tank's own period, "
            "1.67 s, and of the forced one beat",
        .what_is_run = std::string(scheme) + "; in the frame of the tank",
        .spacing = {0.6 / 8, 0.6 / 10, 0.6 / 12, 0.6 / 20, 0.6 / 40, 0.6 / 80},
        .quantities = {{.name = "mean of four crests",
                        .unit = "m",
                        .measured = mean_crest(measured),
                        .u_data = line,
                        .u_input = 0.002,
                        .why = "read from a figure, to the width of its line; the sway to 0.5 mm, "
                               "1.6 %, to which waves are proportional"},
                       {.name = "deepest trough",
                        .unit = "m",
                        .measured = lowest(measured),
                        .u_data = line,
                        .u_input = 0.0015,
                        .why = "the same"},
                       {.name = "time of the first high crest",
                        .unit = "s",
                        .measured = highest(measured, crests[0]).time,
                        .u_data = instant,
                        .u_input = 0.0,
                        .why = "read from a figure to 0.02 s"},
                       {.name = "time of the last crest",
                        .unit = "s",
                        .measured = highest(measured, crests[3]).time,
                        .u_data = instant,
                        .u_input = 0.0,
                        .why = "read from a figure to 0.02 s"}},
        .panels = {{.name = "elevation",
                    .x_label = "t",
                    .x_unit = "s",
                    .y_label = "η",
                    .y_unit = "m",
                    .measured = measured,
                    .low = {},
                    .high = {}}},
        .observe =
            [](double spacing) {
                const Elevation e = swayed_elevation({.tank = {1.73, 1.15},
                                                      .water = {1.73, 0.6},
                                                      .spacing = spacing,
                                                      .sound = 10.0,
                                                      .sway = 0.032,
                                                      .period = 1.3},
                                                     0.05, 9.95);
                const Curve eta{e.t, e.height};
                return Validation::Observation{
                    {mean_crest(eta), lowest(eta), highest(eta, crests[0]).time,
                     highest(eta, crests[3]).time},
                    {eta}};
            },
        .tags = {"sloshing"}};
}

const RegisterValidation free_waves{decay()};
const RegisterValidation forced_waves{sway()};
}  // namespace
}  // namespace sloshing_validation
