/// The bridge's one clock: steady, never set. It is handed in where a test turns it.
#pragma once

#include <chrono>
#include <cstdint>

namespace bridge {

/// Any thread.
class Clock {
  public:
    virtual ~Clock() = default;
    virtual std::int64_t nanoseconds() const = 0;
    double seconds() const { return 1e-9 * static_cast<double>(nanoseconds()); }
};

class SteadyClock final : public Clock {
  public:
    std::int64_t nanoseconds() const override {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    }
};

/// The system's, by which servers say when a frame was published.
inline const Clock& steadyClock() {
    static const SteadyClock clock;
    return clock;
}
inline double nowSeconds() { return steadyClock().seconds(); }

} // namespace bridge
