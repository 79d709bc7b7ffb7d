/// Whole frames from one writer to any number of readers, without waiting on either side.
#pragma once

#include "ipc/layout/frame_segment.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ipc {

/// Size of a segment for frames of up to `frameBytes`.
std::size_t frameSegmentBytes(std::size_t frameBytes, std::uint32_t slotCount);

/// The one writer of a segment. `memory` must outlive it.
class FrameRingWriter {
  public:
    /// Lays a zeroed segment out for `slotCount` frames (3..8) of up to `frameBytes`. The first frame will be
    /// `firstNumber`, at least 1.
    FrameRingWriter(void* memory, std::size_t frameBytes, std::uint32_t slotCount, std::uint64_t epoch,
                    std::uint64_t generation, std::uint64_t firstNumber);

    std::size_t capacity() const { return capacity_; } ///< bytes of the largest frame
    std::uint64_t nextNumber() const { return next_; }

    /// The pixels of the next frame, to be drawn in place. May be called again instead of publish: the frame
    /// is given up. The memory holds an old frame.
    std::span<std::byte> begin();
    /// The frame that was begun is whole. Sets `info.number`; the rest is the caller's.
    void publish(FrameInfo info);
    /// Restores everything that readers use but the pixels, where another process overwrote it.
    void repair();

  private:
    FrameSlot& slot(std::uint64_t number) { return segment_->slot[number % slots_]; }

    FrameSegment* segment_;
    std::size_t capacity_,
        slotBytes_; ///< own copies: another process should not write to the segment, but might
    std::uint32_t slots_;
    std::uint64_t epoch_, generation_, next_;
    FrameInfo last_; ///< number 0: none yet
};

enum class FrameRead {
    New,    ///< `info` and `pixels` hold a newer frame
    Old,    ///< nothing newer
    Missed, ///< the writer came in between each time; try again later
    Broken, ///< the segment is invalid
};

/// One reader. Trusts nothing in the segment: values are copied once, checked, then used.
class FrameRingReader {
  public:
    using Copy = std::function<void(void* to, const void* from, std::size_t bytes)>;

    /// Reads a mapped segment of `bytes`, which must outlive it. `copy` is for tests that write meanwhile.
    FrameRingReader(const void* memory, std::size_t bytes, Copy copy = {});

    /// True once the writer has laid the segment out, for this epoch and generation, with slots within
    /// `bytes`.
    bool ready(std::uint64_t epoch, std::uint64_t generation) const;

    /// Takes the newest frame when its number is not `info.number`. Otherwise `info` and `pixels` stay as
    /// they are, except that `pixels` may hold rubbish after Missed.
    FrameRead read(FrameInfo& info, std::vector<std::byte>& pixels) const;

  private:
    FrameRead tryRead(std::uint64_t number, FrameInfo& info, std::vector<std::byte>& pixels) const;

    const FrameSegment* segment_;
    std::size_t bytes_;
    Copy copy_;
};

/// Bytes of a frame's pixels; 0 when the size or the format is impossible.
std::size_t pixelBytes(const FrameInfo& info);

} // namespace ipc
