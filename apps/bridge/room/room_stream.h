/// Frames of a room: who gets which, and what is asked of the source.
#pragma once

#include "bridge/clock.h"
#include "bridge/control/roles.h"
#include "bridge/net/outlet.h"
#include "bridge/room/room_figures.h"
#include "bridge/stream/delivery.h"
#include "bridge/stream/server_frames.h"
#include "bridge/stream/stream_options.h"
#include "bridge/stream/wire.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>

namespace bridge {

/// One thread. Pages that it does not know are left alone.
class RoomStream {
  public:
    /// `demand` is told what all pages together wait for, whenever that may have changed.
    RoomStream(const StreamOptions& options, const Clock& clock,
               std::function<void(const FrameDemand&)> demand);

    /// Sends nothing but a ping: the delay of the link, before anything fills it.
    void join(SessionId id, const PageView& view, std::shared_ptr<Outlet> outlet);
    void leave(SessionId id);
    /// Sends it what there is for it.
    void serve(SessionId id);

    /// True: newer than all before. Older ones are left out.
    bool newFrames(FrameSet set);

    void setView(SessionId id, const PageView& view);
    void acked(SessionId id, const AckMessage& ack);
    void ponged(SessionId id, double seconds);
    void writable(SessionId id);
    /// The page's input of that number was given to the server.
    void gaveInput(SessionId id, std::uint32_t sequence);

    /// Those that take more than an equal share of the limit get coarser frames: more of them than if they
    /// only waited. To be called about twice a second.
    void shareLimit();
    /// Sends what waited for its turn below the limit.
    void serveWaiting();
    /// Whether a page is seen.
    bool watched() const;
    /// Figures of each link to its page, each second, and pings.
    void tellLinks();

    /// Adds the sessions, without their people, and the counters.
    void addTo(RoomFigures& all) const;

  private:
    /// When which input was given to the server.
    struct Given {
        std::uint32_t sequence;
        std::int64_t ns;
    };
    struct Viewer {
        std::shared_ptr<Outlet> outlet;
        Delivery delivery;
        std::int64_t began = 0; ///< nanoseconds
        double lastLink = 0, lastPing = 0;
        std::uint64_t linkSent = 0, bytes = 0, lastLinkBytes = 0;
        std::deque<Given> given;
        std::int64_t writing =
            0; ///< when the frame was published that is being written, if it came just then
    };
    Viewer* find(SessionId id);
    /// `fresh`: because a frame came.
    void pump(Viewer& viewer, bool fresh = false);
    void send(Viewer& viewer, const Shipment& shipment, bool fresh);
    void updateDemand();
    void measureFrameTime(std::int64_t publishedNs);
    static std::uint32_t inputBefore(Viewer& viewer, std::int64_t ns);
    double sentBits(double now) const; ///< to all pages, within the last second or so
    double equalPart() const { return options_.maxBits / static_cast<double>(viewers_.size()); }
    double allowance(double now) const;
    void tellLink(Viewer& viewer, double now);
    static void pingAfter(Viewer& viewer, double seconds, double now);

    const StreamOptions options_;
    const RungTable rungs_;
    const Clock& clock_;
    const std::function<void(const FrameDemand&)> demand_;
    std::map<SessionId, Viewer> viewers_;
    FrameSet newest_;
    std::int64_t lastPublishedNs_ = 0;
    double frameTime_ = 1.0 / 30;
    std::array<std::uint64_t, kRungCount> framesSent_{};
    std::uint64_t partsSent_ = 0, bytesSent_ = 0;
    std::uint64_t skippedBefore_ = 0; ///< of those that left
    Histogram publishToSocket_;
};

} // namespace bridge
