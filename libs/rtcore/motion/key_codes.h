/// Numbers and names of keys, one byte each. Letters, digits and punctuation are the ASCII code of the
/// unshifted key, letters as capitals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

inline constexpr int kKeyCodes = 256;

enum KeyCode : int {
    KeyNone = 0,
    KeyTab = 9,
    KeyReturn = 13,
    KeyEscape = 27,
    KeySpace = 32,
    KeyLeft = 128,
    KeyRight,
    KeyUp,
    KeyDown,
    KeyShift,
    KeyControl,
    KeyAlt,
    KeyCapsLock,
    KeyPageUp,
    KeyPageDown,
    KeyHome,
    KeyEnd,
    KeyInsert,
    KeyDelete,
    KeyBackspace
};

/// "W", "7", "Space", "Left", "CapsLock"; capitals or not. Nothing for what is no key.
std::optional<int> keyNamed(std::string_view name);
/// "" for a number that is no key.
std::string keyName(int key);

} // namespace rtcore
