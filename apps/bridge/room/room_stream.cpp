#include "bridge/room/room_stream.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace bridge {

RoomStream::RoomStream(const StreamOptions& options, const Clock& clock,
                       std::function<void(const FrameDemand&)> demand)
    : options_(options), rungs_(options.rungs()), clock_(clock), demand_(std::move(demand)) {}

RoomStream::Viewer* RoomStream::find(SessionId id) {
    const auto found = viewers_.find(id);
    return found == viewers_.end() ? nullptr : &found->second;
}

void RoomStream::join(SessionId id, const PageView& view, std::shared_ptr<Outlet> outlet) {
    Viewer& viewer = viewers_[id];
    viewer.outlet = std::move(outlet);
    viewer.began = clock_.nanoseconds();
    viewer.lastLink = viewer.lastPing = clock_.seconds();
    viewer.delivery.prefer(options_.fixedRung());
    viewer.delivery.setView(view);
    viewer.delivery.rate().setFrameTime(frameTime_);
    viewer.outlet->ping();
}

void RoomStream::leave(SessionId id) {
    const Viewer* const viewer = find(id);
    if (viewer == nullptr) return;
    skippedBefore_ += viewer->delivery.framesSkipped();
    viewers_.erase(id);
    if (viewers_.empty()) newest_ = FrameSet();
    updateDemand();
}

void RoomStream::serve(SessionId id) {
    Viewer* const viewer = find(id);
    if (viewer == nullptr) return;
    pump(*viewer);
    updateDemand();
}

bool RoomStream::newFrames(FrameSet set) {
    const bool newer = set.stream != newest_.stream || set.number > newest_.number;
    if (!newer && set.number < newest_.number) return false;
    newest_ = std::move(set);
    if (newer) {
        for (const SharedFrame& frame : newest_.byRung)
            if (frame) measureFrameTime(frame->facts.publishedNs);
        for (auto& [id, viewer] : viewers_) {
            viewer.delivery.offered();
            viewer.delivery.rate().setFrameTime(frameTime_);
        }
    }
    for (auto& [id, viewer] : viewers_) pump(viewer, newer);
    updateDemand();
    return newer;
}

void RoomStream::measureFrameTime(std::int64_t publishedNs) {
    constexpr double kShortest = 1.0 / 60, kLongest = 0.5, kNew = 0.1;
    const double seconds = 1e-9 * static_cast<double>(publishedNs - lastPublishedNs_);
    if (lastPublishedNs_ != 0 && seconds > 0 && seconds < kLongest)
        frameTime_ += kNew * (std::max(seconds, kShortest) - frameTime_);
    if (publishedNs > lastPublishedNs_) lastPublishedNs_ = publishedNs;
}

// --- Messages of pages ---

void RoomStream::setView(SessionId id, const PageView& view) {
    if (Viewer* const viewer = find(id)) viewer->delivery.setView(view);
    serve(id);
}

void RoomStream::acked(SessionId id, const AckMessage& ack) {
    if (Viewer* const viewer = find(id))
        viewer->delivery.rate().acked(ack.stream, ack.number, ack.part, ack.decodeSeconds, clock_.seconds());
    serve(id);
}

void RoomStream::ponged(SessionId id, double seconds) {
    if (Viewer* const viewer = find(id)) viewer->delivery.rate().ponged(seconds, clock_.seconds());
}

void RoomStream::writable(SessionId id) {
    Viewer* const viewer = find(id);
    if (viewer == nullptr) return;
    if (const std::int64_t published = std::exchange(viewer->writing, 0); published != 0)
        publishToSocket_.add(1e-9 * static_cast<double>(clock_.nanoseconds() - published));
    serve(id);
}

void RoomStream::gaveInput(SessionId id, std::uint32_t sequence) {
    constexpr std::size_t kKept = 64;
    Viewer* const viewer = find(id);
    if (viewer == nullptr) return;
    viewer->given.push_back({sequence, clock_.nanoseconds()});
    if (viewer->given.size() > kKept) viewer->given.pop_front();
}

/// The last input that was given before `ns`; what is older than that is forgotten.
std::uint32_t RoomStream::inputBefore(Viewer& viewer, std::int64_t ns) {
    std::deque<Given>& given = viewer.given;
    while (given.size() > 1 && given[1].ns <= ns) given.pop_front();
    return !given.empty() && given.front().ns <= ns ? given.front().sequence : 0;
}

// --- Sending ---

void RoomStream::pump(Viewer& viewer, bool fresh) {
    const double now = clock_.seconds();
    if (viewer.outlet->busy() || viewer.delivery.rate().sentBits(now) > allowance(now)) return;
    if (const std::optional<Shipment> shipment = viewer.delivery.next(newest_, now))
        send(viewer, *shipment, fresh);
}

void RoomStream::send(Viewer& viewer, const Shipment& shipment, bool fresh) {
    const std::int64_t published = shipment.frame->facts.publishedNs;
    const std::int64_t age =
        std::clamp<std::int64_t>((clock_.nanoseconds() - published) / 1000, 0, 0xffffffff);
    viewer.bytes += kHeaderBytes + shipment.size;
    bytesSent_ += kHeaderBytes + shipment.size;
    if (shipment.part) {
        ++partsSent_;
    } else {
        ++framesSent_[static_cast<std::size_t>(shipment.rung)];
        viewer.writing = fresh && published > viewer.began ? published : 0;
    }
    viewer.outlet->sendBinary(
        headerOf(shipment, inputBefore(viewer, published), static_cast<std::uint32_t>(age)), &shipment);
}

void RoomStream::updateDemand() {
    const double now = clock_.seconds(), max = allowance(now);
    FrameDemand demand;
    demand.stream = newest_.stream;
    for (const auto& [id, viewer] : viewers_) {
        const Delivery& delivery = viewer.delivery;
        demand.anyone |= delivery.view().visible;
        demand.still |= delivery.wantsStill();
        demand.fine |= delivery.wantsFine();
        if (viewer.outlet->busy() || delivery.rate().sentBits(now) > max) continue;
        const std::optional<int> rung = delivery.wanted();
        if (!rung) continue;
        std::uint64_t& above = demand.above[static_cast<std::size_t>(*rung)];
        const bool same = delivery.sentStream() == newest_.stream;
        above = std::min(above, same ? delivery.sentNumber() : 0);
    }
    demand_(demand);
}

bool RoomStream::watched() const {
    return std::ranges::any_of(viewers_,
                               [](const auto& each) { return each.second.delivery.view().visible; });
}

// --- The limit of all pages together ---

double RoomStream::sentBits(double now) const {
    double all = 0;
    for (const auto& [id, viewer] : viewers_) all += viewer.delivery.rate().sentBits(now);
    return all;
}

/// The bits per second above which a page must wait: its share, where all pages together are above their
/// limit; else none.
double RoomStream::allowance(double now) const {
    const bool free = options_.maxBits <= 0 || sentBits(now) <= options_.maxBits;
    return free ? std::numeric_limits<double>::infinity() : equalPart();
}

void RoomStream::shareLimit() {
    if (options_.maxBits <= 0 || viewers_.empty()) return;
    const double now = clock_.seconds(), all = sentBits(now);
    for (auto& [id, viewer] : viewers_) {
        RateControl& rate = viewer.delivery.rate();
        constexpr double kRoom = 0.6;
        if (all > options_.maxBits && rate.sentBits(now) > equalPart())
            rate.limit(std::min(std::max(rate.rung(), rate.finest()) + 1, kRungCount - 1));
        else if (all < kRoom * options_.maxBits)
            rate.limit(std::max(rate.finest() - 1, 0));
    }
}

void RoomStream::serveWaiting() {
    if (options_.maxBits <= 0) return;
    for (auto& [id, viewer] : viewers_) pump(viewer);
    updateDemand();
}

// --- Figures ---

void RoomStream::tellLinks() {
    constexpr double kPingEvery = 2, kLinkEvery = 1;
    const double now = clock_.seconds();
    for (auto& [id, viewer] : viewers_) {
        pingAfter(viewer, options_.pingSeconds, now);
        if (now - viewer.lastLink < kLinkEvery) continue;
        const bool sentAny = viewer.delivery.framesSent() != viewer.linkSent;
        tellLink(viewer, now);
        if (sentAny) pingAfter(viewer, kPingEvery, now);
    }
}

/// Nothing where no frame was sent since the last time.
void RoomStream::tellLink(Viewer& viewer, double now) {
    const double mbit =
        8e-6 * static_cast<double>(viewer.bytes - viewer.lastLinkBytes) / (now - viewer.lastLink);
    viewer.lastLink = now;
    viewer.lastLinkBytes = viewer.bytes;
    const std::uint64_t sent = viewer.delivery.framesSent();
    if (sent == std::exchange(viewer.linkSent, sent)) return;
    const LinkReport link = viewer.delivery.rate().report();
    const Rung& rung = rungs_[static_cast<std::size_t>(link.rung)];
    constexpr double kMs = 1000;
    const nlohmann::json event{{"event", "link"},
                               {"rung", link.rung},
                               {"divide", rung.divide},
                               {"quality", rung.quality},
                               {"window", link.window},
                               {"rttMs", link.rtt * kMs},
                               {"baseMs", link.base * kMs},
                               {"queueMs", link.queue * kMs},
                               {"mbit", mbit},
                               {"sent", sent},
                               {"skipped", viewer.delivery.framesSkipped()}};
    viewer.outlet->sendText(event.dump());
}

void RoomStream::pingAfter(Viewer& viewer, double seconds, double now) {
    // Behind a frame a ping would measure that frame.
    if (now - viewer.lastPing < seconds || viewer.delivery.rate().inFlight() > 0) return;
    viewer.lastPing = now;
    viewer.outlet->ping();
}

void RoomStream::addTo(RoomFigures& all) const {
    all.skipped += skippedBefore_;
    for (const auto& [id, viewer] : viewers_) {
        const Delivery& delivery = viewer.delivery;
        all.sessions.push_back({.id = id,
                                .name = {},
                                .drives = false,
                                .link = delivery.rate().report(),
                                .bitsPerSecond = delivery.rate().sentBits(clock_.seconds()),
                                .sent = delivery.framesSent(),
                                .skipped = delivery.framesSkipped(),
                                .seconds = 1e-9 * static_cast<double>(clock_.nanoseconds() - viewer.began)});
        all.skipped += delivery.framesSkipped();
    }
    all.sent = framesSent_;
    all.parts = partsSent_;
    all.bytes = bytesSent_;
    all.publishToSocket = publishToSocket_;
}

} // namespace bridge
