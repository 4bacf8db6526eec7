#pragma once

#include "solver/foundation/errors.h"
#include "solver/kernels/kernel.h"

#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// A compile-time list of kernel families; a family is a template over the dimension, and need not
/// exist in every dimension.
template <template <int> class... Families> struct KernelList {
    /// Calls visit(kernel) with each family's kernel of `support` [m], where it exists in Dim.
    template <int Dim, class Visit> static void for_each(double support, Visit visit) {
        (visit_if_it_exists<Families, Dim>(support, visit), ...);
    }

    /// Calls visit(kernel) with the kernel of that name.
    /// Throws InvalidInput, naming those that exist in Dim, if there is none.
    template <int Dim, class Visit>
    static void with(std::string_view name, double support, Visit visit) {
        bool found = false;
        const auto visit_named = [&]<class K>(std::type_identity<K>) {
            if (K::name != name) return;
            found = true;
            visit(K(support));
        };
        (visit_type<Families, Dim>(visit_named), ...);
        if (found) return;
        std::string expected;
        for (const std::string_view known : names<Dim>()) expected.append(" ").append(known);
        throw InvalidInput("no kernel \"" + std::string(name) + "\" in " + std::to_string(Dim) +
                           "D; expected one of:" + expected);
    }

    template <int Dim> static std::vector<std::string_view> names() {
        std::vector<std::string_view> all;
        const auto add = [&]<class K>(std::type_identity<K>) { all.push_back(K::name); };
        (visit_type<Families, Dim>(add), ...);
        return all;
    }

private:
    template <template <int> class Family, int Dim, class Visit>
    static void visit_type(Visit& visit) {
        if constexpr (requires { typename Family<Dim>; }) visit(std::type_identity<Family<Dim>>{});
    }
    template <template <int> class Family, int Dim, class Visit>
    static void visit_if_it_exists(double support, Visit& visit) {
        if constexpr (requires { typename Family<Dim>; }) visit(Family<Dim>(support));
    }
};

}  // namespace plumbline
