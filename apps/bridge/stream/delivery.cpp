#include "bridge/stream/delivery.h"

#include <algorithm>

namespace bridge {

void Delivery::setView(const PageView& view) {
    view_ = view;
    rate_.pin(view.rung ? std::optional(std::clamp(*view.rung, 0, kRungCount - 1)) : preferred_);
    rate_.floor(view.saveData ? kFirstHalfRung : 0);
}

std::optional<int> Delivery::wanted() const {
    if (!view_.visible || !rate_.windowOpen()) return {};
    return rate_.rung();
}

void Delivery::offered() {
    if (!view_.visible) return;
    rate_.offered();
    ++framesSkipped_; // until it is sent
}

std::optional<Shipment> Delivery::next(const FrameSet& newest, Seconds now) {
    if (!view_.visible || newest.number == 0) return {};
    if (std::optional<Shipment> frame = nextFrame(newest, now)) return frame;
    return nextPart(newest, now);
}

bool Delivery::isSmall(const FrameFacts& facts) const {
    return view_.width > 0 && 2 * view_.width <= facts.shownWidth && 2 * view_.height <= facts.shownHeight;
}

std::optional<Shipment> Delivery::nextFrame(const FrameSet& newest, Seconds now) {
    const bool newer = newest.stream != sentStream_ || newest.number > sentNumber_;
    if (!newer || !rate_.windowOpen()) return {};
    for (int rung = rate_.rung(); rung < kRungCount; ++rung) {
        const SharedFrame& frame = newest.byRung[static_cast<std::size_t>(rung)];
        if (!frame) continue;
        if (!sized_) {
            sized_ = true;
            if (isSmall(frame->facts)) rate_.beginAt(kFirstHalfRung);
        }
        sentStream_ = newest.stream;
        sentNumber_ = newest.number;
        partial_.reset();
        rate_.sent(newest.stream, newest.number, false, frame->bytes.size(), now);
        ++framesSent_;
        if (framesSkipped_ > 0) --framesSkipped_;
        return Shipment{frame, false, 0, frame->bytes.size(), rung};
    }
    return {};
}

std::optional<Shipment> Delivery::nextPart(const FrameSet& newest, Seconds now) {
    const bool shown = newest.stream == sentStream_ && newest.number == sentNumber_;
    if (!shown || !wantsStill() || !rate_.partWindowOpen()) return {};
    // The finer JPEG goes to the end, so that something sharp is there soon; then the exact image.
    const bool finishing = partial_ && partialOffset_ < partial_->bytes.size() && partial_ == newest.fine;
    const bool began = partial_ && (partial_ == newest.fine || partial_ == newest.still);
    if (!began) {
        const SharedFrame& first = newest.fine && rate_.narrow() ? newest.fine : newest.still;
        if (!first) return {};
        partial_ = first;
        partialOffset_ = 0;
    } else if (!finishing && partial_ != newest.still && newest.still) {
        partial_ = newest.still;
        partialOffset_ = 0;
    }
    if (partialOffset_ >= partial_->bytes.size()) return {};
    const std::size_t size = std::min(rate_.partBytes(), partial_->bytes.size() - partialOffset_);
    Shipment part{partial_, true, partialOffset_, size};
    partialOffset_ += size;
    rate_.sent(newest.stream, newest.number, true, size, now);
    return part;
}

} // namespace bridge
