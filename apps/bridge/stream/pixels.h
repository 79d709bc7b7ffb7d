/// Images as they come from a server.
#pragma once

#include <cstddef>
#include <span>

namespace bridge {

/// Pixels of a server: four bytes each, R, G, B and one that is ignored, rows without gaps.
struct Pixels {
    std::span<const std::byte> bytes; ///< 4 * width * height
    int width = 0, height = 0;        ///< 1..ipc::kMaxFrameSide
};

} // namespace bridge
