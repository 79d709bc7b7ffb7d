/// The keys that clients tell a server of: their codes in shared memory, and their names in commands and
/// files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// Letters and digits have the code of their capital ASCII character; others are these.
namespace key {
inline constexpr int kSpace = ' ';
inline constexpr int kLeft = 128, kRight = 129, kUp = 130, kDown = 131;
inline constexpr int kShift = 132, kControl = 133, kCapsLock = 134;
} // namespace key

/// "w", "W", "7", "space", "left", "right", "up", "down", "shift", "ctrl", "capslock"; upper and lower case
/// count as equal.
std::optional<int> keyCode(std::string_view name);

/// All names, for messages.
std::string keyNames();

} // namespace app
