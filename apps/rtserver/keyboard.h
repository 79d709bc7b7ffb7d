/// The keys that commands press.
#pragma once

#include "ipc/layout/key_state.h"

#include <array>
#include <bitset>
#include <cstdint>

namespace rtserver {

/// Keys that belong to no client. One thread.
class Keyboard {
  public:
    void press(int key);
    void release(int key);
    void releaseAll() { down_.reset(); }
    /// Pressed and released: seen by the next collect().
    void tap(int key);
    /// Adds its keys to `state`, and its presses since the last call.
    void collect(ipc::KeyState& state);

  private:
    std::bitset<ipc::kMaxKeys> down_;
    std::array<std::uint32_t, ipc::kMaxKeys> presses_{};
};

} // namespace rtserver
