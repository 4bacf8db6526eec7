#include "reports/charts/spread_ellipse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reports {

namespace {
/// The logarithms, less their mean.
struct Deviations {
    double mean = 0.0;
    std::vector<double> of;

    explicit Deviations(const std::vector<double>& values) {
        for (const double v : values) of.push_back(std::log(v));
        for (const double v : of) mean += v / static_cast<double>(of.size());
        for (double& v : of) v -= mean;
    }
};

double covariance(const Deviations& a, const Deviations& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.of.size(); ++k) sum += a.of[k] * b.of[k];
    return sum / static_cast<double>(a.of.size() - 1);
}
}  // namespace

Chart::Outline spread_ellipse(const std::vector<double>& x, const std::vector<double>& y) {
    const Deviations dx(x), dy(y);
    // The Cholesky factor, lower triangular; without a spread in x the second column alone is left.
    const double l_xx = std::sqrt(covariance(dx, dx));
    const double l_yx = l_xx > 0.0 ? covariance(dx, dy) / l_xx : 0.0;
    const double l_yy = std::sqrt(std::max(0.0, covariance(dy, dy) - l_yx * l_yx));
    const double reach = std::sqrt(-2.0 * std::log(0.05));
    Chart::Outline outline;
    constexpr int corners = 72;
    for (int k = 0; k < corners; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / corners;
        const double u = reach * std::cos(turn), v = reach * std::sin(turn);
        outline.x.push_back(std::exp(dx.mean + l_xx * u));
        outline.y.push_back(std::exp(dy.mean + l_yx * u + l_yy * v));
    }
    return outline;
}

}  // namespace reports
