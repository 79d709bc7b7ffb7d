/// A server's shared memory during one epoch: a control segment and the current frame segment.
#pragma once

#include "ipc/channel/frame_ring.h"
#include "ipc/endpoint/server.h"
#include "ipc/layout/control_block.h"
#include "ipc/platform/names.h"
#include "ipc/platform/segment.h"

#include <memory>
#include <optional>

namespace ipc {

/// One thread. Its names are removed by the destructor.
class Publication {
  public:
    /// Fills `control`, which we have locked; found by others only when it is complete. Frames count on from
    /// `firstFrame`. Throws Error; nothing is left then.
    Publication(const Names& names, Segment control, std::size_t frameBytes, std::uint32_t slotCount,
                std::uint64_t firstFrame);
    ~Publication();
    Publication(const Publication&) = delete;
    Publication& operator=(const Publication&) = delete;

    ControlBlock& block() const { return *static_cast<ControlBlock*>(control_.data()); }
    std::uint64_t epoch() const { return epoch_; }
    FrameRingWriter& frames() { return frames_->ring; }
    const Segment& frameMemory() const { return frames_->segment; }

    /// Shows the last frame of another segment, which has the number that comes next here; nothing when that
    /// has none.
    void takeLastFrame(const Segment& other) { carryLastFrame(other, frames_->ring); }
    /// Another frame segment takes the place of this one, with the last frame in it. On failure (Error
    /// NoSpace) this one stays.
    void replaceFrames(std::size_t frameBytes);
    /// False once the name of the control segment was removed; of the frame segment.
    bool named() const { return control_.named(); }
    bool framesNamed() const { return frames_->segment.named(); }
    /// Whether the client that claimed the slot lives.
    bool slotLocked(int slot) const { return control_.locked(clientLock(slot)); }
    /// Restores the fields that only the server writes, where another process changed them.
    void repair();
    /// Tells attached clients that this server ends, and removes the names.
    void end(ServerPhase last);

  private:
    struct Frames {
        Segment segment;
        FrameRingWriter ring;
        std::uint64_t generation;
    };
    std::unique_ptr<Frames> makeFrames(std::uint64_t generation, std::size_t frameBytes,
                                       std::uint64_t firstFrame);
    static void carryLastFrame(const Segment& from, FrameRingWriter& to);

    Names names_;
    std::uint64_t epoch_;
    std::uint32_t slots_;
    Segment control_;
    std::unique_ptr<Frames> frames_;
    bool ended_ = false;
};

} // namespace ipc
