/// A frame as it is sent. Encoded once, never changed, shared by all viewers.
#pragma once

#include "bridge/stream/rung.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace bridge {

enum class Codec : std::uint8_t { Jpeg = 0, Png = 1 };

/// Which frame of a server it is, and how large.
struct FrameFacts {
    std::uint32_t stream = 0;                      ///< another number after another server or size
    std::uint64_t number = 0;                      ///< of the server's frame, or above it (docs/bridge.md)
    std::uint16_t width = 0, height = 0;           ///< coded
    std::uint16_t shownWidth = 0, shownHeight = 0; ///< stretched to these
    std::int64_t publishedNs = 0;                  ///< by the steady clock
};

struct EncodedFrame {
    FrameFacts facts;
    Codec codec = Codec::Jpeg;
    bool exact = false; ///< it holds the server's pixels
    std::vector<std::uint8_t> bytes;
};
using SharedFrame = std::shared_ptr<const EncodedFrame>;

/// All encodings made so far of one of the server's frames.
struct FrameSet {
    std::uint32_t stream = 0;
    std::uint64_t number = 0;
    std::array<SharedFrame, kRungCount> byRung; ///< null: not encoded
    SharedFrame fine;                           ///< a better JPEG, for narrow links at rest
    SharedFrame still;                          ///< the exact image, at rest
};

} // namespace bridge
