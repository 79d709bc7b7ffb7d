/// Encodes moving frames as JPEG.
#pragma once

#include "bridge/stream/encoded_frame.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace bridge {

/// Pixels of a server: four bytes each, R, G, B and one that is ignored, rows without gaps.
struct Pixels {
    std::span<const std::byte> bytes; ///< 4 * width * height
    int width = 0, height = 0;        ///< 1..16384
};

/// One thread per object; keeps its memory from frame to frame.
class MotionEncoder {
  public:
    MotionEncoder();
    ~MotionEncoder();
    MotionEncoder(const MotionEncoder&) = delete;
    MotionEncoder& operator=(const MotionEncoder&) = delete;

    /// `facts` as they are to be, but for width and height, which follow from the rung: so many times smaller
    /// than what is shown, or as the frame is where the server made it as small itself. Throws
    /// std::runtime_error where the library refuses.
    SharedFrame encode(const Pixels& pixels, const Rung& rung, FrameFacts facts);
    /// For narrow links at rest: full size, colours not subsampled.
    SharedFrame encodeFine(const Pixels& pixels, FrameFacts facts);

  private:
    SharedFrame compress(const Pixels& pixels, int quality, int subsampling, FrameFacts facts);

    void* library_;
    std::vector<std::byte> small_;
    std::vector<unsigned char> buffer_; ///< strips of the frame, each with room for the worst
    std::vector<std::span<const std::uint8_t>> strips_;
};

/// The mean of squares of `divide` x `divide` pixels, rounded; what is left over at the right and the bottom
/// is cut off, but at least one pixel is made. `out` gets the bytes.
Pixels shrink(const Pixels& pixels, int divide, std::vector<std::byte>& out);

} // namespace bridge
