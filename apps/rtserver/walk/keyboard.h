/// The keys that commands press.
#pragma once

#include "ipc/layout/key_state.h"

#include <array>
#include <bitset>
#include <chrono>
#include <cstdint>
#include <vector>

namespace rtserver {

/// Keys that belong to no client. One thread.
class Keyboard {
  public:
    void press(int key);
    /// Until release(), or until advance() has been told of so much time after the next collect(). The number
    /// is for isDown().
    std::uint64_t pressFor(int key, std::chrono::nanoseconds time);
    void release(int key);
    void endPress(std::uint64_t press); ///< of pressFor(): before its time, unless it is up already
    void releaseAll();
    /// Pressed and released: seen by the next collect().
    void tap(int key);

    /// Time goes on. True when a key was released by it.
    bool advance(std::chrono::nanoseconds time);
    /// Until advance() releases a key; the longest time there is when none is pressed for a time.
    std::chrono::nanoseconds untilRelease() const;
    /// Whether this press still holds its key down.
    bool isDown(std::uint64_t press) const;

    const std::bitset<ipc::kMaxKeys>& down() const { return down_; }
    /// Adds its keys to `state`, and its presses since the last call.
    void collect(ipc::KeyState& state);

  private:
    struct TimedPress {
        int key;
        std::uint64_t number;
        std::chrono::nanoseconds left;
        bool collected = false; ///< its time runs
    };

    std::bitset<ipc::kMaxKeys> down_;
    std::array<std::uint32_t, ipc::kMaxKeys> presses_{};
    std::vector<TimedPress> timed_; ///< one for a key at most
    std::uint64_t number_ = 0;
};

} // namespace rtserver
