#include "ipc/endpoint/frame_feed.h"

#include "ipc/platform/error.h"

namespace ipc {

bool FrameFeed::read(const Link& link, Frame& frame) {
    if (!follow(link)) return false;
    FrameInfo info = frame.info;
    if (frame.epoch != epoch_) info.number = 0;
    if (reader_->read(info, frame.pixels) != FrameRead::New) return false;
    frame.info = info;
    frame.epoch = epoch_;
    return true;
}

namespace {

std::optional<Segment> openFrames(const std::string& name) {
    try {
        return Segment::open(name, Access::Read, kPixelsOffset);
    } catch (const Error& error) {
        if (error.problem != Problem::System) throw;
        return std::nullopt; // short of descriptors or memory: the next call tries again
    }
}

} // namespace

// Until the new segment can be opened the old one serves on.
bool FrameFeed::follow(const Link& link) {
    const std::uint64_t generation = link.block().pulse.frameGeneration.load(std::memory_order_acquire);
    if (generation != generation_ || link.epoch() != epoch_) {
        std::optional<Segment> next = openFrames(names_.frames(link.epoch(), generation));
        if (next) {
            FrameRingReader reader(next->data(), next->bytes());
            if (reader.ready(link.epoch(), generation)) {
                reader_.emplace(std::move(reader));
                segment_ = std::move(next);
                epoch_ = link.epoch();
                generation_ = generation;
            }
        }
    }
    return reader_.has_value();
}

} // namespace ipc
