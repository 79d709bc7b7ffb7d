/// Bounds on what the TOML parser is given. toml++ 3.3 limits nested brackets, but not the parts of a dotted
/// key: a key of 100,000 parts overflows the stack when its tables are destroyed, and many dotted keys take a
/// time that grows with their square.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rtcore {

inline constexpr std::size_t kMaxTomlBytes = std::size_t{16} << 20; ///< of a file
inline constexpr std::size_t kMaxTomlDepth = 16;         ///< brackets in brackets; parts of a dotted key
inline constexpr std::size_t kMaxTomlDots = 10'000;      ///< in all keys together
inline constexpr std::size_t kMaxTomlValues = 1'000'000; ///< in the whole file

/// Throws FileError BadData, with line and column, when `text` exceeds a bound. Finds no other errors: text
/// that is no TOML passes, up to where it stops being TOML it is judged correctly.
void guardToml(std::string_view text, const std::string& file);

} // namespace rtcore
