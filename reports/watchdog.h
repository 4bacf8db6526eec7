#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace reports {

/// Ends the program with exit code 4, naming the case, when one takes longer than it may or crashes.
class Watchdog {
public:
    explicit Watchdog(double seconds_per_case);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// The case `id` begins, and the one before has ended.
    void watch(const std::string& id);

private:
    void run(double seconds_per_case);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::string id_;
    unsigned cases_ = 0;
    bool ended_ = false;
    std::thread thread_;
};

}  // namespace reports
