#include "verification/framework/registry.h"
#include "verification/stability/findings.h"
#include "verification/stability/lattice_fluid.h"

#include <fmt/format.h>

namespace stability_lattice_maps {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> std::string runs() {
    return std::string(Dim == 2 ? "hexagonal lattice, 10 by 12" : "close packed lattice, 256") +
           " particles that repeat, random velocities of 1e-9, symplectic Euler";
}
template <int Dim> std::string border_of_runs() {
    return runs<Dim>() +
           "; broken: velocities grow a hundredfold within 500 steps; bisected to 0.4 %";
}
/// The id of a map in the plane, and in space.
template <int Dim> std::string named(const char* id) {
    return id + std::string(Dim == 2 ? "" : "_3d");
}
const Bound two_percent = between(
    0.98, 1.02,
    "bisected to 0.4 %; a wave that is multiplied by 1 + 2 δ per step, δ beyond the border, must "
    "make up for its share "
    "of 1/10 in the velocities and grow a hundredfold in 500 steps: δ < ln(1000)/1000 = 0.7 %");

std::vector<double> range(double low, double high, double step) {
    std::vector<double> all;
    for (int k = 0; low + k * step < high + 0.5 * step; ++k) all.push_back(low + k * step);
    return all;
}
// A box of 4 cells of a close packed lattice is 5.66 wide, and holds a support of less than half of that.
template <int Dim> std::vector<double> supports() { return range(1.5, Dim == 2 ? 3.6 : 2.8, 0.02); }
template <int Dim> std::vector<double> supports_of_runs() {
    return range(1.55, Dim == 2 ? 3.55 : 2.75, 0.2);
}
/// In space a border takes seconds: in a quick run Wendland's C2 has to do, at the first place.
template <int Dim>
std::vector<double> quick_for(std::string_view kernel, const std::vector<double>& at) {
    if constexpr (Dim == 2) return at;
    return kernel == "wendland_c2" ? std::vector{at.front()} : std::vector<double>{};
}

const Map::Axis support_axis{"support h over spacing", "1"};

/// A line per kernel; places of the runs miss the distances of lattice points, where second derivatives may jump.
template <int Dim, class Theory, class Measured>
std::vector<Map::Line> line_per_kernel(Theory theory, Measured measured, const Bound& ratio,
                                       const std::vector<double>& quick_at) {
    std::vector<Map::Line> lines;
    for (const std::string& name : kernels_for_fluids<Dim>())
        lines.push_back({name, [=](double h) { return theory(kernel_of<Dim>(name, h)); },
                         [=](double h, double y) { return measured(kernel_of<Dim>(name, h), y); },
                         quick_for<Dim>(name, quick_at), supports_of_runs<Dim>(), ratio});
    return lines;
}

// The acoustic limit, in h/c; at rest density, where no lattice is unstable.
template <int Dim> double acoustic_theory(const AnyKernel<Dim>& w) {
    return largest_step<Dim>({w}) / w.support();
}
template <int Dim> double acoustic_run(const AnyKernel<Dim>& w, double theory) {
    return bisected([&](double y) { return grows<Dim>({w}, y * w.support()); }, theory);
}
std::string acoustic_finding(const MapResult& result) {
    const Extremes e = extremes_of(result);
    return fmt::format(
        "Sound allows steps of at least {:.2f} h/c ({}, h/s = {:.2f}), so 0.4 {} for every kernel; "
        "{}",
        e.low, e.low_name, e.low_x, e.low > 0.4 ? "is safe" : "is not safe", agreement(result));
}
template <int Dim> std::vector<Map::Line> acoustic_lines() {
    auto lines = line_per_kernel<Dim>(acoustic_theory<Dim>, acoustic_run<Dim>, two_percent, {2.35});
    lines.push_back({"rule: 0.4 h/c", [](double) { return 0.4; }});
    return lines;
}
template <int Dim> Map acoustic_map() {
    return {.id = named<Dim>("acoustic_limit"),
            .source = {Paper::plumbline, "docstring of AcousticLimit"},
            .says = "the largest step of a fluid at rest: 2/ω of its fastest sound wave",
            .x = support_axis,
            .y = {"largest time step over h/c", "1", true},
            .curve_at = supports<Dim>(),
            .lines = acoustic_lines<Dim>(),
            .what_is_run = border_of_runs<Dim>() + "; p = 0",
            .finding = acoustic_finding};
}
const RegisterMap acoustic{acoustic_map<2>()}, acoustic_3d{acoustic_map<3>()};

// The viscous limit, in h²/ν.
template <int Dim> LatticeFluid<Dim> viscous(ViscousForm form, double h) {
    const char* kernel = form == ViscousForm::laplacian ? "viscosity" : "wendland_c2";
    return {kernel_of<Dim>(kernel, h), 0.0, false, form};
}
template <int Dim> Map::Line viscous_line(const char* name, ViscousForm form, const Bound& ratio) {
    return {name,
            [=](double h) { return largest_viscous_step(viscous<Dim>(form, h)) / (h * h); },
            [=](double h, double theory) {
                return bisected([&](double y) { return grows(viscous<Dim>(form, h), y * h * h); },
                                theory);
            },
            quick_for<Dim>(form == ViscousForm::monaghan ? "wendland_c2" : "", {2.35}),
            supports_of_runs<Dim>(),
            ratio};
}
std::string viscous_finding(const MapResult& result) {
    const Extremes e = extremes_of(result);
    return fmt::format(
        "Viscosity allows steps of at least {:.3f} h²/ν ({}, h/s = {:.2f}): 0.04 is {}; {}", e.low,
        e.low_name, e.low_x, e.low > 0.04 ? "safe" : "too long for it", agreement(result));
}
template <int Dim> Map viscous_map() {
    return {
        .id = named<Dim>("viscous_limit"),
        .source = {Paper::plumbline, "docstring of ViscousLimit"},
        .says =
            "the largest step of each form of viscosity: 2/(ν λ) of the wave that it damps most",
        .x = support_axis,
        .y = {"largest time step over h²/ν", "1", true},
        .curve_at = supports<Dim>(),
        .lines = {viscous_line<Dim>("Brookshaw", ViscousForm::brookshaw, two_percent),
                  viscous_line<Dim>("Monaghan 2005", ViscousForm::monaghan, two_percent),
                  viscous_line<Dim>("Laplacian (Müller 2003)", ViscousForm::laplacian, two_percent),
                  viscous_line<Dim>(
                      "artificial, half of the pairs", ViscousForm::artificial,
                      between(0.98, 2.04,
                              "of a wave, each pair at x and −x acts on one side only if both "
                              "have the same velocity; elsewhere fewer act, which is no linear "
                              "theory: from that of the half of all to that of a quarter")),
                  {"rule: 0.04 h²/ν", [](double) { return 0.04; }}},
        .what_is_run = border_of_runs<Dim>() + "; no pressure",
        .finding = viscous_finding};
}
const RegisterMap viscosities{viscous_map<2>()}, viscosities_3d{viscous_map<3>()};

// Growth of what is unstable at any time step.
constexpr double longest_run = 12000.0;  // steps
template <int Dim> double growth(const LatticeFluid<Dim>& fluid, double theory) {
    const double half = 0.5 * largest_step(fluid), h = fluid.w.support();
    if (theory == 0.0) return h * growth_rate(fluid, half, 500.0 * half);
    const double dt = std::min(half, 0.2 * h / theory);
    const double duration = 60.0 * h / theory;
    return duration > longest_run * dt ? NAN : h * growth_rate(fluid, dt, duration);
}
const Bound rate_of_growth = between(0.98, 1.01,
                                     "in the second half of 60 times of growth a wave that grows 5 "
                                     "% more slowly has less than e^−3 of the energy, so "
                                     "that some of them take away 5 % of 5 % each; steps of σ Δt ≤ "
                                     "0.2 change rates by (σ Δt)²/24, 0.2 %");
template <int Dim>
std::vector<Map::Line> growth_lines(double compression, const std::vector<double>& quick_at) {
    return line_per_kernel<Dim>(
        [=](const AnyKernel<Dim>& w) {
            return w.support() * fastest_growth<Dim>({w, compression});
        },
        [=](const AnyKernel<Dim>& w, double y) {
            return growth<Dim>({w, compression}, y);
        },
        rate_of_growth, quick_at);
}
std::string pairing_finding(const MapResult& result) {
    std::string never;
    const Extremes e = extremes_of(result);
    for (const LineResult& line : result.lines)
        if (*std::ranges::max_element(line.curve) < 0.1)
            never += (never.empty() ? "" : ", ") + line.line.name;
    return fmt::format("Compressed by 10 %, {} pairs fastest; growth below 0.1 c/h: {}; {}",
                       e.high_name, never.empty() ? "none" : never, agreement(result));
}
template <int Dim> Map pairing_map() {
    return {.id = named<Dim>("pairing"),
            .source = {Paper::literature, "Dehnen and Aly 2012"},
            .says =
                "how fast the most unstable wave of a lattice compressed by 10 % grows under Eq. "
                "51, at any time step",
            .x = support_axis,
            .y = {"rate of growth over c/h", "1"},
            .curve_at = supports<Dim>(),
            .lines = growth_lines<Dim>(0.1, {1.75, 2.55}),
            .what_is_run = runs<Dim>() + "; steps of half of the acoustic limit, or 0.2/σ",
            .finding = pairing_finding};
}
const RegisterMap pairing{pairing_map<2>()}, pairing_3d{pairing_map<3>()};
std::string tensile_finding(const MapResult& result) {
    const Extremes e = extremes_of(result);
    return fmt::format("Stretched by 1 %, {}; {} at {:.2f} c/h (h/s = {:.2f}), the fastest; {}",
                       e.low > 0.0 ? "every kernel clumps at every support"
                                   : "every kernel clumps, but not at every support",
                       e.high_name, e.high, e.high_x, agreement(result));
}
template <int Dim> Map tensile_map() {
    return {
        .id = named<Dim>("tensile"),
        .source = {Paper::literature, "Swegle, Hicks and Attaway 1995"},
        .says = "how fast the most unstable wave of a lattice stretched by 1 % grows under Eq. 51",
        .x = support_axis,
        .y = {"rate of growth over c/h", "1"},
        .curve_at = supports<Dim>(),
        .lines = growth_lines<Dim>(-0.01, {1.95}),
        .what_is_run = runs<Dim>() + "; steps of half of the acoustic limit, or 0.2/σ",
        .finding = tensile_finding};
}
const RegisterMap tensile{tensile_map<2>()}, tensile_3d{tensile_map<3>()};

// XSPH.
std::string xi_finding(const MapResult& result) {
    const Extremes e = extremes_of(result);
    return fmt::format(
        "XSPH is stable up to ξ = {:.2f} at least ({}, h/s = {:.2f}), the text's limit is 1; {}",
        e.low, e.low_name, e.low_x, agreement(result));
}
template <int Dim> double xi_run(const AnyKernel<Dim>& w, double theory) {
    return bisected(
        [&](double xi) {
            return grows<Dim>({w, 0.0, false, ViscousForm::none, xi}, 1e-3);
        },
        theory);
}
template <int Dim> Map xsph_strength_map() {
    return {.id = named<Dim>("xsph_strength"),
            .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
            .says = "the largest ξ of XSPH without pressure; the text has 0 to 1",
            .x = support_axis,
            .y = {"largest ξ", "1", true},
            .curve_at = supports<Dim>(),
            .lines = line_per_kernel<Dim>(largest_xi<Dim>, xi_run<Dim>, two_percent, {2.35}),
            .what_is_run = border_of_runs<Dim>() + "; no pressure",
            .finding = xi_finding};
}
const RegisterMap xsph_strength{xsph_strength_map<2>()}, xsph_strength_3d{xsph_strength_map<3>()};

Map::Line xsph_line(const char* kernel, double h) {
    return {
        fmt::format("{}, h/s = {}", kernel, h),
        [=](double xi) {
            return largest_step<2>({kernel_of<2>(kernel, h), 0.0, true, ViscousForm::none, xi}) / h;
        },
        [=](double xi, double theory) {
            const auto w = kernel_of<2>(kernel, h);
            if (theory == 0.0)  // at any step, then
                return grows<2>({w, 0.0, true, ViscousForm::none, xi}, 0.01 * h) ? 0.0 : NAN;
            return bisected(
                [&](double y) {
                    return grows<2>({w, 0.0, true, ViscousForm::none, xi}, y * h);
                },
                theory);
        },
        {0.5, 1.0},
        range(0.0, 2.0, 0.2),
        two_percent};
}
std::string xsph_finding(const MapResult& result) {
    const LineResult& line = result.lines.front();
    const auto at = [&](double x) {
        const auto k =
            std::ranges::find_if(result.map.curve_at, [&](double a) { return a > x - 1e-9; });
        return line.curve[static_cast<std::size_t>(k - result.map.curve_at.begin())];
    };
    return fmt::format("XSPH with ξ = 1 lowers the largest step of sound by {:.0f} % ({}); {}",
                       100.0 * (1.0 - at(1.0) / at(0.0)), line.line.name, agreement(result));
}
const RegisterMap xsph{Map{
    .id = "xsph_step",
    .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
    .says = "the largest step with XSPH, Δt² ω² = 2 (1 + s), where a step multiplies velocities "
            "by s = 1 − ξ λ",
    .x = {"ξ of each step", "1"},
    .y = {"largest time step over h/c", "1"},
    .curve_at = range(0.0, 2.2, 0.02),
    .lines = {xsph_line("wendland_c2", 2.35), xsph_line("cubic_spline", 2.15),
              xsph_line("poly6", 2.35), xsph_line("wendland_c6", 3.35)},
    .what_is_run = border_of_runs<2>() + "; p = 0",
    .finding = xsph_finding}};

// The same as claims, with a theory that is wrong on purpose.
double monaghan_over(double factor) {
    const Map::Line line = viscous_line<2>("", ViscousForm::monaghan, two_percent);
    const double theory = factor * line.theory(2.35);
    return line.measured(2.35, theory) / theory;
}
double xi_over(double factor) {
    const auto w = kernel_of<2>("poly6", 2.35);
    return xi_run(w, factor * largest_xi(w)) / (factor * largest_xi(w));
}
double step_over(double xi_of_theory) {
    const Map::Line line = xsph_line("wendland_c2", 2.35);
    return line.measured(0.5, line.theory(0.5)) / line.theory(xi_of_theory);
}
/// min over supports of the exact limit of Monaghan's viscosity over fraction h²/ν.
double margin_of_monaghan(double fraction) {
    const Map::Line line = viscous_line<2>("", ViscousForm::monaghan, two_percent);
    double least = HUGE_VAL;
    for (const double h : supports<2>()) least = std::min(least, line.theory(h) / fraction);
    return least;
}
double growth_over(double compression_of_theory) {
    const auto w = kernel_of<2>("poly6", 1.65);
    const double theory = 1.65 * fastest_growth<2>({w, compression_of_theory});
    return growth<2>({w, 0.1}, theory) / theory;
}
const Register claims_of_maps{
    Claim{
        .id = "stability.monaghan_border",
        .source = {Paper::literature, "Euler's step decays iff λ Δt ≤ 2"},
        .says = "Monaghan's viscosity begins to shake at Δt = 2/(ν λ): measured border over theory",
        .bound = two_percent,
        .measure = [] { return monaghan_over(1.0); },
        .sabotaged = [] { return monaghan_over(1.05); }},
    Claim{.id = "stability.monaghan_rule_is_safe",
          .source = {Paper::plumbline, "docstring of ViscousLimit"},
          .says = "exact limit of Monaghan's viscosity, Wendland C2, over the 0.025 h²/ν of scene "
                  "files, 1.5 to 3.6 spacings per support: the least; Brookshaw's 0.04 is too long",
          .bound = at_least(1.0, "below 1 the shortest waves grow"),
          .measure = [] { return margin_of_monaghan(0.025); },
          .sabotaged = [] { return margin_of_monaghan(0.04); }},
    Claim{.id = "stability.xsph_border",
          .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
          .says = "XSPH alone shakes beyond ξ = 2/λ: measured border over theory",
          .bound = two_percent,
          .measure = [] { return xi_over(1.0); },
          .sabotaged = [] { return xi_over(1.05); }},
    Claim{
        .id = "stability.xsph_lowers_the_step",
        .source = {Paper::plumbline, "verification/stability/lattice_fluid.h"},
        .says =
            "with ξ = 0.5 the acoustic border is at Δt² ω² = 2 (1 + s): measured over theory; the "
            "limit without XSPH is too long",
        .bound = two_percent,
        .measure = [] { return step_over(0.5); },
        .sabotaged = [] { return step_over(0.0); }},
    Claim{.id = "stability.rate_of_pairing",
          .source = {Paper::literature, "Dehnen and Aly 2012"},
          .says = "poly6, h/s = 1.65, compressed by 10 %: rate of growth of pairs, measured over "
                  "theory",
          .bound = rate_of_growth,
          .measure = [] { return growth_over(0.1); },
          .sabotaged = [] { return growth_over(0.09); }}};
}  // namespace
}  // namespace stability_lattice_maps
