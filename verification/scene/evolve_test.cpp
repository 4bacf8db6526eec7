#include "solver/scene/evolve.h"

#include <catch2/catch.hpp>

namespace evolve_test {
namespace {
using namespace plumbline;

struct AddOne {
    using Reads = Quantities<>;
    using Writes = Quantities<Accelerations<2>, Rate<Density>>;
    void run(double, Accelerations<2>& a, Rate<Density>& rate) const {
        for (auto& a_i : a) a_i += Vec<2>::Ones();
        for (double& r : rate) r += 1.0;
    }
};

TEST_CASE("rates are evaluated from zero, one for each member") {
    Velocities<2> v;
    v.assign(3, Vec<2>::Zero());
    Accelerations<2> a;
    a.assign(1, Vec<2>(7, 7));
    Density rho;
    rho.assign(3, 1.0);
    Rate<Density> rate;
    const Arguments<Quantities<>, Velocities<2>, Accelerations<2>, Density, Rate<Density>> at(
        v, a, rho, rate);
    Evolve<2, Density>::evaluate(at, 0.1, std::tuple{AddOne{}, AddOne{}});
    CHECK(a == std::vector<Vec<2>>(3, Vec<2>(2, 2)));
    CHECK(rate == std::vector<double>(3, 2.0));
}

TEST_CASE("an array is advanced from where it was") {
    const std::vector<double> start{1.0, 2.0}, rate{10.0, 20.0};
    std::vector<double> q(2);
    advance(q, start, 0.5, rate);
    CHECK(q == std::vector<double>{6.0, 12.0});
}
}  // namespace
}  // namespace evolve_test
