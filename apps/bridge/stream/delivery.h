/// The choice of what one viewer is sent next. It holds no frame but the one whose parts are under way, and
/// queues nothing: the newest frame wins.
#pragma once

#include "bridge/stream/encoded_frame.h"
#include "bridge/stream/rate_control.h"

#include <cstddef>
#include <optional>

namespace bridge {

/// A page's view and wishes, as it reports them.
struct PageView {
    bool visible = true;
    std::optional<int> rung = {}; ///< chosen by hand
    bool saveData = false;        ///< half size at most, no exact image
    bool noStill = false;
    int width = 0, height = 0; ///< pixels that it has; 0: not said
};

/// Bytes of a frame that are to be sent.
struct Shipment {
    SharedFrame frame;
    bool part = false; ///< of a still; else all of it
    std::size_t offset = 0, size = 0;
    int rung = 0; ///< of what is no part
};

/// One thread, no clock, no socket.
class Delivery {
  public:
    void setView(const PageView& view);
    /// The rung of a page that chooses none; nothing: by its link.
    void prefer(std::optional<int> rung) { preferred_ = rung; }
    const PageView& view() const { return view_; }
    RateControl& rate() { return rate_; }
    const RateControl& rate() const { return rate_; }

    /// The rung that it waits for; nothing while it is hidden or its window is full. It waits for frames
    /// whose number is above `sentNumber()`.
    std::optional<int> wanted() const;
    std::uint64_t sentNumber() const { return sentNumber_; }
    std::uint32_t sentStream() const { return sentStream_; }
    /// Whether it would take the resting frame, exactly or finer.
    bool wantsStill() const { return view_.visible && !view_.noStill && !view_.saveData; }
    bool wantsFine() const { return wantsStill() && rate_.narrow(); }

    /// The bytes of the newest frame to send now, which count as sent; nothing: wait for an acknowledgement
    /// or for another frame.
    std::optional<Shipment> next(const FrameSet& newest, Seconds now);

    std::uint64_t framesSent() const { return framesSent_; }
    std::uint64_t framesSkipped() const { return framesSkipped_; }
    /// A newer frame than all before is there.
    void offered();

  private:
    std::optional<Shipment> nextFrame(const FrameSet& newest, Seconds now);
    std::optional<Shipment> nextPart(const FrameSet& newest, Seconds now);
    bool isSmall(const FrameFacts& facts) const;

    PageView view_;
    std::optional<int> preferred_;
    RateControl rate_;
    std::uint32_t sentStream_ = 0;
    std::uint64_t sentNumber_ = 0;
    SharedFrame partial_; ///< whose parts are under way, or were sent last
    std::size_t partialOffset_ = 0;
    std::uint64_t framesSent_ = 0, framesSkipped_ = 0;
    bool sized_ = false; ///< the first rung was chosen by the page's size
};

} // namespace bridge
