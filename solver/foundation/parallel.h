#pragma once

#include <omp.h>

#include <cstddef>
#include <exception>

namespace plumbline {

inline int thread_count() { return omp_get_max_threads(); }
inline void set_thread_count(int n) { omp_set_num_threads(n); }

/// Calls body(i) for every i in [0, n), on all threads. The bodies may run in any order, so each
/// writes only what belongs to its own i; then the result does not depend on the number of threads.
/// Threads take `grain` bodies at a time: 256 for light ones, 1 for heavy ones.
/// Rethrows the exception of one of the bodies that threw, once the loop has ended.
template <class Body> void parallel_for(std::size_t n, Body body, int grain = 256) {
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, grain) if (n > static_cast <std::size_t>(grain))
    for (std::size_t i = 0; i < n; ++i) {
        try {
            body(i);
        } catch (...) {
#pragma omp critical(plumbline_parallel_for)
            failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

/// Calls body(first, last) for parts of [0, n) that together cover it, each of a few thousand
/// indices: for loops so light that a call for every index would show.
template <class Body> void parallel_for_parts(std::size_t n, Body body) {
    constexpr std::size_t part = 4096;
    parallel_for((n + part - 1) / part,
                 [&](std::size_t k) { body(k * part, k * part + part < n ? k * part + part : n); },
                 1);
}

}  // namespace plumbline
