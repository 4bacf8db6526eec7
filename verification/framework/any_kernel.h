#pragma once

#include "solver/kernels/kernel.h"

#include <memory>

namespace verification {

/// A kernel whose type is forgotten, for a name chosen at run time: one instantiation of each
/// method serves all kernels, for a virtual call at each neighbour.
template <int Dim> class AnyKernel {
public:
    static constexpr std::string_view name = "any kernel";
    static constexpr int dim = Dim;

    template <plumbline::RadialKernel K>
    explicit AnyKernel(const K& w) : kernel_{std::make_shared<Known<K>>(w)} {}

    double support() const { return kernel_->support(); }
    double value(double r) const { return kernel_->value(r); }
    double derivative(double r) const { return kernel_->derivative(r); }
    double second_derivative(double r) const { return kernel_->second_derivative(r); }
    double laplacian(double r) const { return kernel_->laplacian(r); }

private:
    struct Interface {
        virtual ~Interface() = default;
        virtual double support() const = 0;
        virtual double value(double r) const = 0;
        virtual double derivative(double r) const = 0;
        virtual double second_derivative(double r) const = 0;
        virtual double laplacian(double r) const = 0;
    };
    template <class K> struct Known final : Interface {
        explicit Known(const K& kernel) : w{kernel} {}
        double support() const override { return w.support(); }
        double value(double r) const override { return w.value(r); }
        double derivative(double r) const override { return w.derivative(r); }
        double second_derivative(double r) const override { return w.second_derivative(r); }
        double laplacian(double r) const override { return plumbline::laplacian(w, r); }
        K w;
    };
    std::shared_ptr<const Interface> kernel_;
};

}  // namespace verification
