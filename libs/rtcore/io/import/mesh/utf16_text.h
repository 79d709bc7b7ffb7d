/// Text files in UTF-16, such as Irrlicht and some editors write, for readers that know UTF-8 alone.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace rtcore {

/// Whether the bytes begin with the byte order mark of UTF-16, of either order; no model of bytes does.
bool beginsAsUtf16(std::span<const std::byte> bytes);

/// The text in UTF-8, without the mark, by iconv() of the C library. Nothing where it does not begin so, or
/// is not sound to its end.
std::optional<std::string> utf8OfUtf16(std::span<const std::byte> bytes);

} // namespace rtcore
