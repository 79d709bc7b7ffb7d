/// A frame in memory of the viewer's own.
#pragma once

#include "ipc/layout/frame_info.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ipc {

struct Frame {
    FrameInfo info;                ///< number 0: none yet
    std::vector<std::byte> pixels; ///< 4 * width * height bytes
    std::uint64_t epoch = 0;       ///< of the server that drew it; numbers start again with another one
};

} // namespace ipc
