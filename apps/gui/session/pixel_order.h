/// From the order of the frames in shared memory to the one that Qt paints by copying.
#pragma once

#include <cstddef>
#include <span>

namespace gui {

/// Bytes R G B A become what QImage::Format_RGB32 wants, opaque, in place. Qt itself takes several passes and
/// three times as long. `pixels` holds whole pixels, aligned to four bytes.
void toRgb32(std::span<std::byte> pixels);

} // namespace gui
