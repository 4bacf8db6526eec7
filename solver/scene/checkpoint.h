#pragma once

#include "solver/foundation/errors.h"
#include "solver/scene/scene.h"

#include <cstring>
#include <string>

namespace plumbline {

namespace detail {
/// What each step finds anew from the positions, as lists of neighbours; to be specialised for others.
template <class Q> inline constexpr bool found_anew = requires(const Q q) { q.lists; };
/// One number or several that lie in the object itself, without padding, as TimeStepLimits.
template <class Q>
concept PlainValue = std::is_trivially_copyable_v<Q>;

template <class T> void append_bytes(std::string& bytes, const T* data, std::size_t n) {
    bytes.append(reinterpret_cast<const char*>(data), n * sizeof(T));
}
inline void take_bytes(std::string_view& bytes, void* to, std::size_t n) {
    if (bytes.size() < n)
        throw InvalidInput("checkpoint: expected " + std::to_string(n) +
                           " more bytes, found the end of the data");
    if (n > 0) std::memcpy(to, bytes.data(), n);
    bytes.remove_prefix(n);
}
}  // namespace detail

/// Appends to `bytes` everything that a scene holds and no step finds anew: arrays of particles and of
/// ghosts, and plain values. Another scene of the same type that takes these bytes goes on bit for
/// bit as the one that gave them. A quantity of another kind does not compile here, so that none is forgotten.
template <class... Passes> void save_state(const Scene<Passes...>& scene, std::string& bytes) {
    const auto save = [&]<class Q>(const Q& q) {
        if constexpr (detail::OnePerMember<Q>) {
            const std::size_t n = q.size();
            detail::append_bytes(bytes, &n, 1);
            detail::append_bytes(bytes, q.data(), n);
        } else if constexpr (!detail::found_anew<Q>) {
            static_assert(detail::PlainValue<Q>, "does a checkpoint need this quantity?");
            detail::append_bytes(bytes, &q, 1);
        }
    };
    [&]<class... Qs>(Quantities<Qs...>) {
        (save(scene.template get<Qs>()), ...);
    }(typename Scene<Passes...>::Stored{});
}

/// The reverse: `bytes` is what save_state appended. Throws InvalidInput if it is too short or too long, or if
/// arrays of one set differ in length; the scene is then not to be used.
template <class... Passes> void load_state(Scene<Passes...>& scene, std::string_view bytes) {
    const auto load = [&]<class Q>(Q& q) {
        if constexpr (detail::OnePerMember<Q>) {
            std::size_t n = 0;
            detail::take_bytes(bytes, &n, sizeof n);
            if (n > bytes.size())
                throw InvalidInput("checkpoint: expected the number of " + std::string(Q::name) +
                                   ", found " + std::to_string(n));
            q.resize(n);
            detail::take_bytes(bytes, q.data(), n * sizeof(typename Q::value_type));
        } else if constexpr (!detail::found_anew<Q>) {
            detail::take_bytes(bytes, &q, sizeof q);
        }
    };
    [&]<class... Qs>(Quantities<Qs...>) {
        (load(scene.template get<Qs>()), ...);
    }(typename Scene<Passes...>::Stored{});
    if (!bytes.empty())
        throw InvalidInput("checkpoint: expected the end of the data, found " +
                           std::to_string(bytes.size()) + " more bytes");
}

}  // namespace plumbline
