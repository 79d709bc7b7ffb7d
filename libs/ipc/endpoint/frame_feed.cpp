#include "ipc/endpoint/frame_feed.h"

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

// Until the new segment can be opened the old one serves on.
bool FrameFeed::follow(const Link& link) {
    const std::uint64_t generation = link.block().pulse.frameGeneration.load(std::memory_order_acquire);
    if (generation != generation_ || link.epoch() != epoch_) {
        std::optional<Segment> next =
            Segment::open(names_.frames(link.epoch(), generation), Access::Read, kPixelsOffset);
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
