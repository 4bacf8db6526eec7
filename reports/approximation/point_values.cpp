#include "reports/approximation/point_values.h"

#include "solver/approximation/density.h"
#include "solver/approximation/mlsph_shape.h"
#include "solver/approximation/mueller_gradient.h"
#include "solver/approximation/shape_functions.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_shape.h"
#include "solver/neighbours/cell_grid.h"

#include "solver/kernels/all_kernels.h"
#include "verification/framework/any_kernel.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace reports {
namespace {
using namespace plumbline;
using verification::AnyKernel;

/// A shape method whose kernel and order are forgotten, so that one loop serves all of them.
template <int Dim> struct AnyShape {
    static constexpr int dim = Dim;
    std::function<std::optional<Fit>(std::span<const Vec<Dim>>, const Place<Dim>&, ShapeRow<Dim>)>
        call;
    std::optional<Fit> operator()(std::span<const Vec<Dim>> x, const Place<Dim>& at,
                                  ShapeRow<Dim> row) const {
        return call(x, at, row);
    }
};

template <int Dim> struct Inputs {
    Points<Dim> x, at;
    const std::vector<double>& f;
    std::vector<double> mass;
    NeighbourLists among_samples, of_queries;

    Inputs(const ApproximationTask& task)
        : x(task.samples.points_as<Dim>()),
          at(task.at.points_as<Dim>()),
          f(task.samples.column(task.field)),
          mass(task.mass ? task.samples.column(*task.mass) : std::vector<double>(x.size(), 1.0)) {
        CellGrid<Dim> search;
        search.build(x, task.support);
        search.query(at, of_queries);
        if (task.method.family == Family::sph || task.method.family == Family::shepard)
            search.query(x, among_samples);
    }
    Place<Dim> place(Index i) const { return {at[i], of_queries.of(i)}; }
};

template <int Dim> std::vector<double> components(const Vec<Dim>& v) {
    return {v.data(), v.data() + Dim};
}

/// Nothing but the reason, where there is no number or it is not one. Second derivatives can fail
/// alone: at a sample where the kernel has a kink.
PointValue stated(PointValue p, const std::string& why_empty) {
    if (!p.value) return {{}, {}, {}, why_empty};
    bool finite = std::isfinite(*p.value);
    for (const double g : p.gradient) finite = finite && std::isfinite(g);
    if (!finite) return {{}, {}, {}, "not_finite"};
    if (p.laplacian && !std::isfinite(*p.laplacian)) {
        p.laplacian.reset();
        if (p.status == "ok") p.status = "no_laplacian";
    }
    return p;
}

std::string status_of(const Method& method, const Fit& fit) {
    if (method.family == Family::mlsph && fit.order < method.order)
        return fmt::format("reduced_order:{}", fit.order);
    return fit.complete() ? "ok" : fmt::format("rank_deficient:{}", fit.rank);
}

/// Whether ⟨Δf⟩ estimates Δf: exact for quadratic f from order 2 on (adams2009 Eq. 34). Order −1 is SPH, whose
/// Laplacian is Eq. 11.
bool has_laplacian(const Fit& fit) { return fit.order < 0 || fit.order >= 2; }

template <int Dim>
std::vector<PointValue> by_shape_functions(const Inputs<Dim>& in, const Method& method,
                                           const AnyShape<Dim>& shape_of) {
    const bool at_samples = method.family == Family::mueller;
    const auto shape =
        precompute<AnyShape<Dim>>(shape_of, in.x, in.at, in.of_queries,
                                  at_samples ? Derivatives::gradient : Derivatives::laplacian);
    return at_all(in.at.size(), [&](Index i) {
        PointValue p;
        if (const auto& fit = shape.fit[i]) {
            p.value = shape.value(in.f, i);
            p.gradient = components<Dim>(*shape.gradient(in.f, i));
            p.status = status_of(method, *fit);
            if (!at_samples && has_laplacian(*fit)) p.laplacian = shape.laplacian(in.f, i);
            if (!at_samples && !p.laplacian && p.status == "ok") p.status = "no_laplacian";
        }
        return stated(p, in.of_queries.of(i).empty() ? "no_neighbours" : "not_finite");
    });
}

template <int Dim>
std::vector<PointValue> by_shepard(const AnyKernel<Dim>& w, const Inputs<Dim>& in,
                                   const Samples<Dim>& samples) {
    return at_all(in.at.size(), [&](Index i) {
        const auto place = in.place(i);
        const auto gradient = shepard_gradient(w, samples, in.f, place);
        const PointValue p{shepard(w, samples, in.f, place),
                           gradient ? components<Dim>(*gradient) : std::vector<double>{},
                           {},
                           gradient ? "no_laplacian" : "no_gradient"};
        return stated(p, place.neighbours.empty() ? "no_neighbours" : "not_finite");
    });
}

/// Why the Müller gradient has nothing, or nothing certain, to say at a point.
template <int Dim> std::optional<std::string> not_one_sample(const Inputs<Dim>& in, Index i) {
    std::optional<double> value;
    for (const Index j : in.of_queries.of(i)) {
        if (in.x[j] != in.at[i]) continue;
        if (value && *value != in.f[j]) return "repeated_sample";
        value = in.f[j];
    }
    if (!value) return in.of_queries.of(i).empty() ? "no_neighbours" : "not_a_sample";
    return std::nullopt;
}

template <int Dim>
std::vector<PointValue> by_mueller(const AnyKernel<Dim>& w, const Inputs<Dim>& in,
                                   const Method& method) {
    auto points = by_shape_functions<Dim>(in, method, {MuellerShape<AnyKernel<Dim>>(w)});
    for (Index i = 0; i < points.size(); ++i) {
        if (const auto why = not_one_sample(in, i))
            points[i] = {{}, {}, {}, *why};
        else if (!points[i].value)
            points[i].status = "rank_deficient:1";
    }
    return points;
}

template <int Dim>
AnyShape<Dim> moving_least_squares(const AnyKernel<Dim>& w, const Method& method) {
    using K = AnyKernel<Dim>;
    const bool variable = method.family == Family::mlsph;
    const auto choose = [&]<int Order>() -> AnyShape<Dim> {
        if (variable) return {MlsphShape<Order, K>(w)};
        return {MlsShape<Order, K>(w)};
    };
    switch (method.order) {
        case 0:
            return choose.template operator()<0>();
        case 1:
            return choose.template operator()<1>();
        case 2:
            return choose.template operator()<2>();
        default:
            return choose.template operator()<3>();
    }
}

/// Vⱼ of adams2009 Eq. 4. A kernel that is infinite at 0 has no density at its samples: Shepard's quotient
/// takes equal volumes then, SPH cannot do without.
template <int Dim>
std::vector<double> volumes_of(const AnyKernel<Dim>& w, const Inputs<Dim>& in, Family family,
                               const std::string& kernel) {
    if (w.value(0.0) < HUGE_VAL) return volumes(w, in.x, in.mass, in.among_samples);
    if (family == Family::sph)
        throw InvalidInput(
            fmt::format("sph: expected a kernel that is finite at 0, found \"{}\", with which the "
                        "density at every sample is infinite",
                        kernel));
    require_positive("mass", in.mass);
    return std::vector<double>(in.x.size(), 1.0);
}

template <int Dim>
std::vector<PointValue> with_kernel(const AnyKernel<Dim>& w, const Inputs<Dim>& in,
                                    const Method& method, const std::string& kernel) {
    using K = AnyKernel<Dim>;
    switch (method.family) {
        case Family::mls:
        case Family::mlsph:
            return by_shape_functions<Dim>(in, method, moving_least_squares(w, method));
        case Family::mueller:
            return by_mueller(w, in, method);
        case Family::sph:
        case Family::shepard:
            break;
    }
    const auto V = volumes_of(w, in, method.family, kernel);
    const Samples<Dim> samples{in.x, V, in.among_samples};
    if (method.family == Family::shepard) return by_shepard(w, in, samples);
    return by_shape_functions<Dim>(in, method, {SphShape<K>(w, samples)});
}

template <int Dim> std::vector<PointValue> in_dimension(const ApproximationTask& task) {
    std::vector<PointValue> points;
    AllKernels::with<Dim>(task.kernel, task.support, [&](const auto& w) {
        points = with_kernel(AnyKernel<Dim>(w), Inputs<Dim>(task), task.method, task.kernel);
    });
    return points;
}

}  // namespace

const std::vector<NamedMethod>& methods() {
    static const std::vector<NamedMethod> all = [] {
        std::vector<NamedMethod> list{
            {"sph", {Family::sph}, "adams2009 Eqs. 3, 9, 11", "exact for no polynomial"},
            {"shepard",
             {Family::shepard},
             "adams2009 Sec. 2.1",
             "normalised weights; exact for constants; interpolates with a singular kernel"}};
        for (int order = 0; order <= 3; ++order)
            list.push_back({fmt::format("mls:{}", order),
                            {Family::mls, order},
                            "adams2009 Eqs. 27-34",
                            fmt::format("moving least squares, exact to degree {}", order)});
        for (int order = 0; order <= 3; ++order)
            list.push_back(
                {fmt::format("mlsph:{}", order),
                 {Family::mlsph, order},
                 "adams2009 Sec. 4",
                 fmt::format("the highest order up to {} that the samples determine", order)});
        list.push_back({"mueller",
                        {Family::mueller},
                        "adams2009 Eqs. 35-38",
                        "gradient at samples, exact for linear fields"});
        return list;
    }();
    return all;
}

Method parse_method(std::string_view text) {
    for (const NamedMethod& known : methods())
        if (known.name == text) return known.method;
    throw InvalidInput(fmt::format(
        "expected sph, shepard, mls:N, mlsph:N (N = 0, 1, 2 or 3) or mueller, found \"{}\"", text));
}

std::vector<PointValue> approximate(const ApproximationTask& task) {
    if (!(task.support > 0.0 && std::isfinite(task.support)))
        throw InvalidInput(
            fmt::format("expected a positive, finite support, found {}", task.support));
    if (task.samples.dim != task.at.dim)
        throw InvalidInput(
            fmt::format("expected samples and points of one dimension, found {}D samples and {}D "
                        "points",
                        task.samples.dim, task.at.dim));
    return task.samples.dim == 2 ? in_dimension<2>(task) : in_dimension<3>(task);
}

}  // namespace reports
