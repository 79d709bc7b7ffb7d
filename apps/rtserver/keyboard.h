/// What the keys do, as data, and the keys that commands press.
#pragma once

#include "rtserver/flying.h"

#include "ipc/layout/key_state.h"

#include <bitset>
#include <cstdint>
#include <span>

namespace rtserver {

/// Held keys move the camera. A row with `with` counts only while that key is held, and then goes before the
/// rows of the same key without it.
struct Binding {
    int key;
    int with; ///< 0 = none
    Action action;
};

/// W A S D and arrows move, I and O go up and down, CapsLock with arrows turns, Shift hurries.
std::span<const Binding> defaultBindings();

/// The actions that these keys ask for.
std::bitset<kActions> actionsOf(const std::bitset<ipc::kMaxKeys>& keys, std::span<const Binding> bindings);

/// Keys that belong to no client: commands press and release them. One thread.
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
