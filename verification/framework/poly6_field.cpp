#include "verification/framework/poly6_field.h"

namespace verification {

using plumbline::Vec;

template <int Dim>
Real50 poly6_field(const Patch<Dim>& patch, const std::vector<double>& f, double h,
                   const Point50<Dim>& x) {
    Real50 sum = 0;
    for (std::size_t j = 0; j < patch.x.size(); ++j) {
        const Point50<Dim> x_j = patch.x[j].template cast<Real50>();
        Real50 r_squared = 0;
        for (int d = 0; d < Dim; ++d) r_squared += (x[d] - x_j[d]) * (x[d] - x_j[d]);
        sum += f[j] * poly6_to_50_digits(Dim, h, r_squared).value * patch.V[j];
    }
    return sum;
}

template <int Dim> Vec<Dim> gradient_to_20_digits(const Field50<Dim>& field, const Vec<Dim>& at) {
    const Real50 step("1e-12");
    Vec<Dim> slope;
    for (int d = 0; d < Dim; ++d) {
        Point50<Dim> ahead = at.template cast<Real50>(), behind = ahead;
        ahead[d] += step, behind[d] -= step;
        slope[d] = static_cast<double>((field(ahead) - field(behind)) / (2 * step));
    }
    return slope;
}

template <int Dim> double laplacian_to_20_digits(const Field50<Dim>& field, const Vec<Dim>& at) {
    const Real50 step("1e-12");
    const Point50<Dim> x = at.template cast<Real50>();
    Real50 sum = 0;
    for (int d = 0; d < Dim; ++d) {
        Point50<Dim> ahead = x, behind = x;
        ahead[d] += step, behind[d] -= step;
        sum += (field(ahead) - 2 * field(x) + field(behind)) / (step * step);
    }
    return static_cast<double>(sum);
}

template Real50 poly6_field(const Patch<1>&, const std::vector<double>&, double, const Point50<1>&);
template Vec<1> gradient_to_20_digits<1>(const Field50<1>&, const Vec<1>&);
template double laplacian_to_20_digits<1>(const Field50<1>&, const Vec<1>&);
template Real50 poly6_field(const Patch<2>&, const std::vector<double>&, double, const Point50<2>&);
template Vec<2> gradient_to_20_digits<2>(const Field50<2>&, const Vec<2>&);
template double laplacian_to_20_digits<2>(const Field50<2>&, const Vec<2>&);
template Real50 poly6_field(const Patch<3>&, const std::vector<double>&, double, const Point50<3>&);
template Vec<3> gradient_to_20_digits<3>(const Field50<3>&, const Vec<3>&);
template double laplacian_to_20_digits<3>(const Field50<3>&, const Vec<3>&);

}  // namespace verification
