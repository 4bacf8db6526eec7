#include "benchmarks/framework/memory.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace benchmarks {

namespace {
/// A number of kB in /proc/self/status, in bytes.
std::optional<std::size_t> status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == key)
            if (std::size_t kilobytes = 0; status >> kilobytes) return 1024 * kilobytes;
    return {};
}
}  // namespace

std::size_t allocated_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

void release_freed_memory() { malloc_trim(0); }

PeakMemory::PeakMemory() {
    release_freed_memory();
    std::ofstream reset("/proc/self/clear_refs");  // 5: the peak starts again from here (proc(5))
    reset << "5" << std::flush;
    if (reset) before_ = status_bytes("VmRSS:");
}

std::optional<std::size_t> PeakMemory::bytes() const {
    const auto peak = status_bytes("VmHWM:");
    if (!before_ || !peak) return {};
    return *peak > *before_ ? *peak - *before_ : 0;
}

CacheSizes cache_sizes() {
    const auto bytes = [](int name) {
        return static_cast<std::size_t>(std::max(0L, sysconf(name)));
    };
    return {bytes(_SC_LEVEL2_CACHE_SIZE), bytes(_SC_LEVEL3_CACHE_SIZE)};
}

void empty_caches() {
    constexpr std::size_t larger_than_caches = std::size_t{64} << 20, line = 64;
    static std::vector<unsigned char> filler(larger_than_caches, 1);
    for (std::size_t at = 0; at < filler.size(); at += line) ++filler[at];
    [[maybe_unused]] volatile unsigned char used = filler.front();
}

}  // namespace benchmarks
