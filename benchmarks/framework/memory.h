#pragma once

#include <cstddef>
#include <optional>

namespace benchmarks {

/// The bytes that are allocated now, by whatever library, as glibc's allocator counts them.
std::size_t allocated_bytes();

/// Gives freed memory back to the system, so that the next allocation is of new memory.
void release_freed_memory();

/// The most memory that was held at once since the construction, beyond what was held then, as the
/// kernel counts pages: to within some 0.5 MB. Empty where the system cannot tell. Freed memory is
/// given back first.
class PeakMemory {
public:
    PeakMemory();
    std::optional<std::size_t> bytes() const;

private:
    std::optional<std::size_t> before_;
};

/// The bytes of a core's own cache and of the one that cores share; 0 where the system does not say.
struct CacheSizes {
    std::size_t own, shared;
};
CacheSizes cache_sizes();

/// Replaces what the processor's caches hold.
void empty_caches();

}  // namespace benchmarks
