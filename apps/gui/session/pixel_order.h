/// From the order of the frames in shared memory to the one that Qt paints by copying.
#pragma once

#include <cstddef>
#include <span>

namespace gui {

/// Bytes R G B A become what QImage::Format_RGB32 wants, opaque, in place. Qt itself takes several passes and
/// three times as long. `pixels` holds whole pixels, aligned to four bytes.
void toRgb32(std::span<std::byte> pixels);

/// The same, but pixels whose A is 0 become those of `below`, which has that order already and as many
/// pixels.
void toRgb32Over(std::span<std::byte> pixels, std::span<const std::byte> below);

} // namespace gui
