#include "solver/approximation/density.h"

#include "solver/approximation/sph_interpolation.h"
#include "solver/foundation/random.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/invariances.h"
#include "verification/framework/lattice_sums.h"
#include "verification/framework/registry.h"

namespace density_claims {
namespace {
using namespace plumbline;
using namespace verification;

double relative(double found, double expected) { return std::abs(found / expected - 1.0); }

template <int Dim> const Disordered<Dim>& disordered() {
    static const Disordered<Dim> samples(2.5);
    return samples;
}

/// max |Vᵢ ρᵢ^power / mᵢ − 1|.
template <int Dim> double volume_times_density(double power) {
    const auto& d = disordered<Dim>();
    double worst = 0.0;
    for (std::size_t i = 0; i < d.size(); ++i)
        worst = std::max(worst, relative(d.patch.V[i] * std::pow(d.rho[i], power), d.m[i]));
    return worst;
}

/// Eq. 5 in the order of its derivation: ⟨ρ⟩ with Vⱼ = weight(mⱼ) / ρⱼ, whatever the ρⱼ are.
double interpolated_density(double (*weight)(double m)) {
    auto d = disordered<2>();
    const double rho = d.rho[d.patch.centre];
    Random random(5);
    for (std::size_t j = 0; j < d.size(); ++j) {
        d.rho[j] = random.uniform(0.1, 10.0);
        d.patch.V[j] = weight(d.m[j]) / d.rho[j];
    }
    const auto s = d.samples();
    return relative(interpolate<Poly6<2>>(d.w, s, d.rho, s.at(d.patch.centre)), rho);
}

/// Mean of f over the disc of radius `eps` around x, weighted with poly6: ∫ f δ(x − x′) dV′ for small eps.
template <class F> double near_delta(const Vec<2>& x, double eps, F f) {
    const Poly6<2> delta(eps);
    constexpr int n_angles = 8;
    return integrate(
        [&](double r) {
            double ring = 0.0;
            for (int k = 0; k < n_angles; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / n_angles;
                ring += f(Vec<2>(x + r * Vec<2>(std::cos(angle), std::sin(angle))));
            }
            return delta.value(r) * r * ring * 2.0 * std::numbers::pi / n_angles;
        },
        0.0, eps);
}

/// ∫ m(x′) g(x′) dV′ with m(x′) as Eq. 6 prints it: mᵢ at the samples, 0 elsewhere. By any rule of quadrature.
template <class G> double integrate_mass_as_printed(G g) {
    const auto& d = disordered<2>();
    const auto m = [&](const Vec<2>& x) {
        for (Index i = 0; i < d.size(); ++i)
            if (d.patch.x[i] == x) return d.m[i];
        return 0.0;
    };
    double total = 0.0;
    for (double x = -5.995; x < 6.0; x += 0.1)
        for (double y = -5.995; y < 6.0; y += 0.1) total += 0.1 * 0.1 * m({x, y}) * g(Vec<2>(x, y));
    return total;
}
constinit Mutant eq_6_without_deltas{30, "Eq. 6: m(x) = mᵢ at xᵢ", "mass as a function"};
/// The same with m(x′) = Σᵢ mᵢ δ(x′ − xᵢ).
template <class G> double integrate_mass(G g) {
    if (eq_6_without_deltas.applied()) return integrate_mass_as_printed(g);
    const auto& d = disordered<2>();
    double total = 0.0;
    for (Index i = 0; i < d.size(); ++i) total += d.m[i] * near_delta(d.patch.x[i], 1e-4, g);
    return total;
}
double total_mass() {
    double total = 0.0;
    for (const double m : disordered<2>().m) total += m;
    return total;
}
double weight_at_centre(const Vec<2>& x) {
    const auto& d = disordered<2>();
    return d.w.value((x - d.patch.x[d.patch.centre]).norm());
}
double rho_at_centre() { return disordered<2>().rho[disordered<2>().patch.centre]; }

/// ∫ ρ dV / Σ m by the trapezoidal rule with 20 points per support: one sample is enough.
double mass_in_density(const Poly6<2>& w) {
    const Points<2> x{{0.1, 0.2}};
    const std::vector<double> m{3.0};
    const std::vector<Index> self{0};
    const double step = 0.05;
    double total = 0.0;
    for (int a = -25; a <= 25; ++a)
        for (int b = -25; b <= 25; ++b)
            total += density<Poly6<2>>(w, x, m, {Vec<2>(a * step, b * step), self}) * step * step;
    return total / m[0];
}

/// max over j of |Σᵢ mᵢ ω(‖xᵢ − xⱼ‖; hᵢ) / ρⱼ − 1|, every sample giving to its neighbours what ρ takes.
template <int Dim> double given_against_taken(double spread_of_supports) {
    const auto& d = disordered<Dim>();
    std::vector<double> given(d.size(), 0.0);
    Random random(3);
    for (Index i = 0; i < d.size(); ++i) {
        const Poly6<Dim> w_i(d.w.support() * (1.0 - spread_of_supports * random.uniform()));
        for (const Index j : d.patch.neighbours.of(i))
            given[j] += d.m[i] * w_i.value((d.patch.x[i] - d.patch.x[j]).norm());
    }
    double worst = 0.0;
    for (std::size_t j = 0; j < d.size(); ++j)
        worst = std::max(worst, relative(given[j], d.rho[j]));
    return worst;
}

template <int Dim> double density_of_unit_masses(const Patch<Dim>& patch, double h) {
    const std::vector<double> m(patch.x.size(), 1.0);
    return density<Poly6<Dim>>(Poly6<Dim>(h), patch.x, m, patch.samples().at(patch.centre));
}

template <int Dim> double error_on_lattice(const KnownLattice<Dim>& known, double searched) {
    double worst = 0.0;
    for (const double h : {1.6, 2.2, 2.7, 3.3}) {
        const Patch<Dim> patch(known.lattice, {.support = searched * h, .reach = 1.0});
        const double found = patch.V[patch.centre] * density_of_unit_masses(patch, h);
        worst =
            std::max(worst, relative(found, static_cast<double>(lattice_sums(known, h).density)));
    }
    return worst;
}

/// Σ ω over the points k·step, k whole, of a line through the sample: the sum over a row of the lattice.
Real50 row(const Real50& step, double h) {
    Real50 sum = poly6_to_50_digits(2, h, 0).value;
    for (int k = 1; k * step < h; ++k)
        sum += 2 * poly6_to_50_digits(2, h, k * k * step * step).value;
    return sum;
}
/// What a sample of a hexagonal lattice sees, of the bulk's density, on the last row that is left of
/// the lattice; and at the right-angled corner of that row and the line across it. By reflection a
/// half is (all + its row) / 2 and a quarter is (all + its two rows + itself) / 4.
double seen_on_flat_surface(double h) {
    const auto& hexagonal = plane_lattices()[1];
    const Real50 all = lattice_sums(hexagonal, h).density / hexagonal.cell_volume;
    return static_cast<double>((all + row(1, h)) / (2 * all));
}
double seen_at_corner(double h) {
    const auto& hexagonal = plane_lattices()[1];
    const Real50 all = lattice_sums(hexagonal, h).density / hexagonal.cell_volume;
    const Real50 self = poly6_to_50_digits(2, h, 0).value;
    return static_cast<double>((all + row(1, h) + row(sqrt(Real50(3)), h) + self) / (4 * all));
}
double surface_error(int free_faces, double (*seen)(double h)) {
    double worst = 0.0;
    for (const double h : {2.0, 2.5, 3.0}) {
        const Patch<2> bulk(hexagonal_lattice(1.0), {.support = h});
        const Patch<2> cut(hexagonal_lattice(1.0), {.support = h, .free_faces = free_faces});
        const double share = density_of_unit_masses(cut, h) / density_of_unit_masses(bulk, h);
        worst = std::max(worst, relative(share, seen(h)));
    }
    return worst;
}

template <int Dim> double change_of_density(bool scale_support) {
    return change_under_similarity<Dim>(2.5, Dim, [=](const auto& d, Index i) {
        const Poly6<Dim> w(scale_support ? d.w.support() : 2.5);
        return density<Poly6<Dim>>(w, d.patch.x, d.m, d.samples().at(i));
    });
}

double density_of_lonely_sample(bool feels_itself) {
    const Points<3> x{{1.0, 2.0, 3.0}};
    const std::vector<double> m{2.0};
    const std::vector<Index> neighbours(feels_itself ? 1 : 0, 0);
    const Poly6<3> w(0.5);
    return density<Poly6<3>>(w, x, m, {x[0], neighbours}) / (m[0] * w.value(0.0));
}

const std::string rounding_2d =
    "25 terms with 10 roundings each: 35 · 1.1e-16, relative to Σ |terms|";
const std::string rounding_3d =
    "90 terms with 10 roundings each: 100 · 1.1e-16, relative to Σ |terms|";
template <int Dim>
std::vector<Claim> claims_on_lattices(const std::vector<KnownLattice<Dim>>& lattices) {
    std::vector<Claim> claims;
    for (const KnownLattice<Dim>& known : lattices)
        claims.push_back(
            {.id = "density.on_lattice_" + known.name,
             .source = {Paper::adams2009, "Eq. 5"},
             .says = "ρ on the lattice is the sum over its shells, whose sizes number theory gives",
             .bound = at_most(3e-14, "up to 250 positive terms: 260 · 1.1e-16"),
             .measure = [&known] { return error_on_lattice(known, 1.0); },
             .sabotaged = [&known] { return error_on_lattice(known, 0.8); }});
    return claims;
}
const Register on_the_line{claims_on_lattices(line_lattices())};
const Register on_plane_lattices{claims_on_lattices(plane_lattices())};
const Register on_space_lattices{claims_on_lattices(space_lattices())};

const Register claims_of_density{
    Erratum{.number = 30,
            .source = {Paper::adams2009, "Eq. 6"},
            .printed = "m(x) = mᵢ at x = xᵢ, 0 elsewhere: its integral is 0",
            .corrected = "m(x) = Σᵢ mᵢ δ(x − xᵢ)"},
    &eq_6_without_deltas,
    Claim{.id = "density.volume_times_density_is_mass",
          .source = {Paper::adams2009, "Eq. 4"},
          .says = "Vᵢ ρᵢ = mᵢ for every sample",
          .bound = at_most(4 * unit_roundoff, "a quotient and a product: 2 roundings each way"),
          .measure = [] { return volume_times_density<3>(1.0); },
          .sabotaged = [] { return volume_times_density<3>(-1.0); }},
    Claim{.id = "density.does_not_need_the_density",
          .source = {Paper::adams2009, "Eq. 5"},
          .says =
              "⟨ρ⟩ with Vⱼ = mⱼ / ρⱼ is Σ ω mⱼ for any ρⱼ whatever: the derivation is circular, "
              "the result is right",
          .bound = at_most(35 * unit_roundoff, rounding_2d),
          .measure = [] { return interpolated_density([](double m) { return m; }); },
          .sabotaged = [] { return interpolated_density([](double) { return 1.0; }); }},
    Claim{
        .id = "density.mass_function_holds_the_mass",
        .source = {Paper::adams2009, "Eq. 6"},
        .says = "∫ m(x) dV is the mass of all samples, relatively; as printed it is 0",
        .bound = between(1.0 - 1e-12, 1.0 + 1e-12, "relative accuracy of the quadrature: 1e-13"),
        .measure = [] { return integrate_mass([](const Vec<2>&) { return 1.0; }) / total_mass(); },
        .sabotaged =
            [] {
                return integrate_mass_as_printed([](const Vec<2>&) { return 1.0; }) / total_mass();
            },
        .erratum = 30},
    Claim{.id = "density.is_the_smoothed_mass_function",
          .source = {Paper::adams2009, "Eq. 7"},
          .says = "∫ m(x′) ω(x − x′) dV′ / ρ = 1 where m is a comb of peaks of radius 1e-4",
          .bound = between(1.0 - 1e-8, 1.0 + 1e-8,
                           "a peak of radius ε adds ε²/20 Δω: 5e-10 Σ m |Δω| / ρ < 1e-8"),
          .measure = [] { return integrate_mass(weight_at_centre) / rho_at_centre(); },
          .sabotaged = [] { return integrate_mass_as_printed(weight_at_centre) / rho_at_centre(); },
          .erratum = 30},
    Claim{.id = "density.holds_the_mass",
          .source = {Paper::adams2009, "Eqs. 5, 8"},
          .says = "∫ ρ dV = Σ m",
          .bound = between(1.0 - 1e-6, 1.0 + 1e-6,
                           "Poisson's sum: 4 ω̂(2π 20) of the trapezoidal rule with 20 points per "
                           "support, ω̂(k) < 24 (2 / k)⁴ √(2 / (π k)) = 1.1e-7; next ones less"),
          .measure = [] { return mass_in_density(Poly6<2>(1.0)); },
          .sabotaged = [] { return mass_in_density(Poly6<2>(1.25)); }},
    Claim{
        .id = "density.given_is_taken_2d",
        .source = {Paper::adams2009, "Eq. 5"},
        .says = "Σᵢ mᵢ ωᵢⱼ = ρⱼ: samples may give to their neighbours instead of taking from them",
        .bound = at_most(35 * unit_roundoff, rounding_2d),
        .measure = [] { return given_against_taken<2>(0.0); },
        .sabotaged = [] { return given_against_taken<2>(0.2); }},
    Claim{
        .id = "density.given_is_taken_3d",
        .source = {Paper::adams2009, "Eq. 5"},
        .says = "Σᵢ mᵢ ωᵢⱼ = ρⱼ: samples may give to their neighbours instead of taking from them",
        .bound = at_most(100 * unit_roundoff, rounding_3d),
        .measure = [] { return given_against_taken<3>(0.0); },
        .sabotaged = [] { return given_against_taken<3>(0.2); }},
    Claim{.id = "density.of_a_lonely_sample",
          .source = {Paper::adams2009, "Eq. 5"},
          .says = "a sample feels itself: alone it has the density m ω(0), and so a finite volume",
          .bound = between(1.0, 1.0, "one product, the same on both sides"),
          .measure = [] { return density_of_lonely_sample(true); },
          .sabotaged = [] { return density_of_lonely_sample(false); }},
    Claim{
        .id = "density.on_a_flat_surface",
        .source = {Paper::adams2009, "Eq. 5; Sec. 2"},
        .says =
            "on the surface of a hexagonal lattice only 0.754, 0.701, 0.669 of the bulk's density "
            "are seen for supports of 2, 2.5, 3 spacings",
        .bound =
            at_most(60 * unit_roundoff, "two sums of up to 31 positive terms, and their ratio"),
        .measure = [] { return surface_error(1, seen_on_flat_surface); },
        .sabotaged = [] { return surface_error(0, seen_on_flat_surface); }},
    Claim{
        .id = "density.at_a_corner",
        .source = {Paper::adams2009, "Eq. 5; Sec. 2"},
        .says = "at a right-angled corner of a hexagonal lattice only 0.517, 0.451, 0.414 are seen",
        .bound =
            at_most(60 * unit_roundoff, "two sums of up to 31 positive terms, and their ratio"),
        .measure = [] { return surface_error(2, seen_at_corner); },
        .sabotaged = [] { return surface_error(1, seen_at_corner); }},
    Claim{
        .id = "density.scales_and_moves_1d",
        .source = {Paper::adams2009, "Eq. 5"},
        .says = "scaled, reflected, shifted, reordered samples have the density ρ / λ",
        .bound = at_most(10 * position_rounding, "h² ∫ |ω′| dV Σ m / V = 2.2 · 2.5 · 1.5 supports"),
        .measure = [] { return change_of_density<1>(true); },
        .sabotaged = [] { return change_of_density<1>(false); }},
    Claim{.id = "density.scales_and_moves_2d",
          .source = {Paper::adams2009, "Eq. 5"},
          .says = "scaled, turned, shifted, reordered samples have the density λ⁻² ρ",
          .bound =
              at_most(50 * position_rounding, "h³ ∫ |ω′| dV Σ m / V = 3.7 · 6.25 · 1.5 supports"),
          .measure = [] { return change_of_density<2>(true); },
          .sabotaged = [] { return change_of_density<2>(false); }},
    Claim{.id = "density.scales_and_moves_3d",
          .source = {Paper::adams2009, "Eq. 5"},
          .says = "scaled, turned, shifted, reordered samples have the density λ⁻³ ρ",
          .bound =
              at_most(150 * position_rounding, "h⁴ ∫ |ω′| dV Σ m / V = 4.9 · 15.6 · 1.5 supports"),
          .measure = [] { return change_of_density<3>(true); },
          .sabotaged = [] { return change_of_density<3>(false); }},
};
}  // namespace
}  // namespace density_claims
