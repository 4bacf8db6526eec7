#pragma once

#include <type_traits>

namespace plumbline {

/// A list of quantity types; a quantity is a type that names one array, as Density does.
template <class... Qs> struct Quantities {};

template <class List, class Q> inline constexpr bool contains = false;
template <class... Qs, class Q>
inline constexpr bool contains<Quantities<Qs...>, Q> = (std::is_same_v<Qs, Q> || ...);

namespace detail {
template <class Left, class Right> struct Joined;
template <class... Ls> struct Joined<Quantities<Ls...>, Quantities<>> {
    using type = Quantities<Ls...>;
};
template <class... Ls, class Q, class... Rest>
struct Joined<Quantities<Ls...>, Quantities<Q, Rest...>>
    : Joined<std::conditional_t<(std::is_same_v<Ls, Q> || ...), Quantities<Ls...>,
                                Quantities<Ls..., Q>>,
             Quantities<Rest...>> {};

template <class... Lists> struct United { using type = Quantities<>; };
template <class List> struct United<List> {
    using type = typename Joined<Quantities<>, List>::type;
};
template <class First, class Second, class... Rest>
struct United<First, Second, Rest...> : United<typename Joined<First, Second>::type, Rest...> {};

template <class Kept, class List, class Without> struct Filtered { using type = Kept; };
template <class... Kept, class Q, class... Rest, class Without>
struct Filtered<Quantities<Kept...>, Quantities<Q, Rest...>, Without>
    : Filtered<
          std::conditional_t<contains<Without, Q>, Quantities<Kept...>, Quantities<Kept..., Q>>,
          Quantities<Rest...>, Without> {};
}  // namespace detail

/// All quantities of the lists, each once, in the order of their first appearance.
template <class... Lists> using Union = typename detail::United<Lists...>::type;

/// The quantities of `List` that are not in `Without`.
template <class List, class Without>
using Difference = typename detail::Filtered<Quantities<>, List, Without>::type;

}  // namespace plumbline
