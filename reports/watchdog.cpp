#include "reports/watchdog.h"

#include "reports/commands/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace reports {

namespace {
std::array<char, 256> current{};  // a signal handler can read neither a string nor a lock

void write_text(const char* text, std::size_t n) {
    if (write(STDERR_FILENO, text, n) < 0) _exit(static_cast<int>(ExitCode::crashed));
}

void name_the_crashed(int) {
    constexpr std::string_view head = "plumbline: crashed in ";
    write_text(head.data(), head.size());
    write_text(current.data(),
               static_cast<std::size_t>(std::ranges::find(current, '\0') - current.begin()));
    write_text("\n", 1);
    _exit(static_cast<int>(ExitCode::crashed));
}
}  // namespace

Watchdog::Watchdog(double seconds_per_case) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        std::signal(signal, name_the_crashed);
    thread_ = std::thread([this, seconds_per_case] { run(seconds_per_case); });
}

Watchdog::~Watchdog() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    changed_.notify_all();
    thread_.join();
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        std::signal(signal, SIG_DFL);
}

void Watchdog::watch(const std::string& id) {
    {
        const std::lock_guard lock(mutex_);
        id_ = id;
        ++cases_;
        current.fill('\0');
        std::copy_n(id.begin(), std::min(id.size(), current.size() - 1), current.begin());
    }
    changed_.notify_all();
}

void Watchdog::run(double seconds_per_case) {
    std::unique_lock lock(mutex_);
    while (!ended_) {
        const unsigned watched = cases_;
        const bool went_on =
            changed_.wait_for(lock, std::chrono::duration<double>(seconds_per_case),
                              [&] { return ended_ || cases_ != watched; });
        if (went_on || watched == 0) continue;
        fmt::print(stderr, "plumbline: {} took longer than {} s\n", id_, seconds_per_case);
        std::fflush(nullptr);
        _exit(static_cast<int>(ExitCode::crashed));
    }
}

}  // namespace reports
