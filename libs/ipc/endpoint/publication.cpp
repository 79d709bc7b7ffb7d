#include "ipc/endpoint/publication.h"

#include "ipc/channel/shared_copy.h"
#include "ipc/endpoint/link.h"
#include "ipc/platform/error.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/rules.h"
#include "ipc/platform/system.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace ipc {

Publication::Publication(const Names& names, Segment control, std::size_t frameBytes, std::uint32_t slotCount,
                         std::uint64_t firstFrame)
    : names_(names), epoch_(randomTag()), slots_(slotCount), control_(std::move(control)) {
    try {
        faultPoint("control made");
        ControlBlock& block = *new (control_.data()) ControlBlock;
        ControlHeader& header = block.header;
        if (!keeps("the magic number comes last")) header.magic.store(kControlMagic);
        header.handshake = ownHandshake();
        header.epoch = epoch_;
        header.serverProcess = processId();
        faultPoint("header written");
        frames_ = makeFrames(1, frameBytes, firstFrame);
        block.pulse.frameGeneration.store(1, std::memory_order_relaxed);
        faultPoint("before magic");
        header.magic.store(kControlMagic, std::memory_order_release);
        faultPoint("after magic");
    } catch (...) {
        Segment::remove(names_.control());
        throw;
    }
}

Publication::~Publication() {
    if (!ended_) end(ServerPhase::Left);
}

std::unique_ptr<Publication::Frames> Publication::makeFrames(std::uint64_t generation, std::size_t frameBytes,
                                                             std::uint64_t firstFrame) {
    Segment segment =
        Segment::create(names_.frames(epoch_, generation), frameSegmentBytes(frameBytes, slots_));
    FrameRingWriter ring(segment.data(), frameBytes, slots_, epoch_, generation, firstFrame);
    return std::make_unique<Frames>(Frames{std::move(segment), ring, generation});
}

void Publication::carryLastFrame(const Segment& from, FrameRingWriter& to) {
    FrameInfo info;
    std::vector<std::byte> pixels;
    if (FrameRingReader(from.data(), from.bytes()).read(info, pixels) != FrameRead::New) return;
    if (pixels.size() > to.capacity()) return;
    std::memcpy(to.begin().data(), pixels.data(), pixels.size());
    to.publish(info);
}

void Publication::replaceFrames(std::size_t frameBytes) {
    const std::uint64_t last = std::max<std::uint64_t>(1, frames_->ring.nextNumber() - 1);
    std::unique_ptr<Frames> next = makeFrames(frames_->generation + 1, frameBytes, last);
    carryLastFrame(frames_->segment, next->ring);
    faultPoint("frames replaced");
    block().pulse.frameGeneration.store(next->generation, std::memory_order_release);
    Segment::remove(names_.frames(epoch_, frames_->generation));
    frames_ = std::move(next);
}

void Publication::repair() {
    ControlHeader& header = block().header;
    keep(header.handshake, ownHandshake());
    keep(header.epoch, epoch_);
    keep(header.serverProcess, processId());
    keep(header.magic, kControlMagic);
    keep(block().pulse.frameGeneration, frames_->generation);
    keep(block().pulse.phase, ServerPhase::Running);
    frames_->ring.repair();
}

void Publication::end(ServerPhase last) {
    ended_ = true;
    block().pulse.phase.store(last, std::memory_order_release);
    // A name that we lost may now belong to another process's segment.
    if (control_.named()) Segment::remove(names_.control());
    Segment::remove(names_.frames(epoch_, frames_->generation));
    control_.unlock(kServerLock);
    for (ClientSlot& slot : block().clients) ring(slot.bell);
}

} // namespace ipc
