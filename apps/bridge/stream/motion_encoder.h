/// Encodes moving frames as JPEG.
#pragma once

#include "bridge/stream/encoded_frame.h"
#include "bridge/stream/pixels.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace bridge {

/// One thread per object; keeps its memory from frame to frame.
class MotionEncoder {
  public:
    MotionEncoder();
    ~MotionEncoder();
    MotionEncoder(const MotionEncoder&) = delete;
    MotionEncoder& operator=(const MotionEncoder&) = delete;

    /// `facts` as they are to be, but for width and height, which follow from the rung: so many times smaller
    /// than what is shown, or as the frame is where the server made it smaller still. Throws
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

} // namespace bridge
