/// Encodes a resting frame exactly, as PNG.
#pragma once

#include "bridge/stream/motion_encoder.h"

#include <memory>

struct libdeflate_compressor;

namespace bridge {

/// One thread per object; keeps its memory.
class StillEncoder {
  public:
    StillEncoder();
    ~StillEncoder();
    StillEncoder(const StillEncoder&) = delete;
    StillEncoder& operator=(const StillEncoder&) = delete;

    /// 8 bits of red, green and blue a pixel, without alpha. Throws std::runtime_error, std::bad_alloc.
    SharedFrame encode(const Pixels& pixels, FrameFacts facts);

  private:
    libdeflate_compressor* library_;
    std::vector<unsigned char> filtered_, compressed_;
};

} // namespace bridge
