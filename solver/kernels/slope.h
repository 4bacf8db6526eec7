#pragma once

#include "solver/kernels/wendland_c2.h"

namespace plumbline {

/// ω′(r)/r in whatever numbers the kernel's sums are done in, several at a time too: ∇ω(x) = (ω′/r) x,
/// without a division and without a special case at r = 0, where the quotient is the limit ω″(0).
/// For the kernels that have one; agrees with K::derivative to some roundings of ω″(0).
template <class K> class SlopeOverRadius;

/// −20 σ (1 − q)³ / h^(dim + 2), q = r/h, and σ / h^dim = ω(0).
template <int Dim>
requires(Dim == 2 || Dim == 3) class SlopeOverRadius<WendlandC2<Dim>> {
public:
    explicit SlopeOverRadius(const WendlandC2<Dim>& w)
        : inverse_support_{1.0 / w.support()},
          at_zero_{-20.0 * w.value(0.0) * inverse_support_ * inverse_support_} {}

    template <class Number> Number operator()(Number r) const {
        using std::max;
        const Number t = max(Number(1.0) - Number(inverse_support_) * r, Number(0.0));
        return Number(at_zero_) * t * t * t;
    }

private:
    double inverse_support_, at_zero_;
};

}  // namespace plumbline
