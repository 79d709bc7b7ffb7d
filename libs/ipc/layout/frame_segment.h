/// The frame segment: a ring of whole frames. A segment never changes its size; another size is another
/// segment. Frame n lies in slot n % slotCount. The sequence of a slot is 2n+1 while frame n is written and
/// 2n+2 when it is whole.
#pragma once

#include "ipc/layout/frame_info.h"
#include "ipc/layout/limits.h"

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ipc {

inline constexpr std::uint64_t kFramesMagic = 0x314D524653545221; ///< "!RTSFRM1"
inline constexpr std::size_t kPixelsOffset = 4096;                ///< of the first slot's pixels

struct alignas(64) FrameSlot {
    std::atomic<std::uint64_t> sequence;
    FrameInfo info;
};

struct FrameSegment {
    std::atomic<std::uint64_t> magic; ///< stored last
    std::uint64_t epoch;              ///< of the control segment
    std::uint64_t generation;
    std::atomic<std::uint64_t> slotBytes; ///< room for one frame's pixels, a multiple of 4096
    std::atomic<std::uint32_t> slotCount;
    alignas(
        64) std::atomic<std::uint64_t> latest; ///< number of the newest whole frame, 0 = none; stored last
    FrameSlot slot[kMaxFrameSlots];
};
static_assert(sizeof(FrameSlot) == 64 && sizeof(FrameSegment) <= kPixelsOffset);

} // namespace ipc
