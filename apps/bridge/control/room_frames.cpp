// The frames of a room: who gets which, and what is asked of the source.
#include "bridge/control/room.h"

#include <algorithm>
#include <limits>

namespace bridge {

namespace {

/// The last input that was given before `ns`; what is older than that is forgotten.
std::uint32_t inputBefore(Session& session, std::int64_t ns) {
    while (session.given.size() > 1 && session.given[1].ns <= ns) session.given.pop_front();
    return !session.given.empty() && session.given.front().ns <= ns ? session.given.front().sequence : 0;
}

} // namespace

void Room::newFrames(FrameSet set) {
    const bool newer = set.stream != newest_.stream || set.number > newest_.number;
    if (!newer && set.number < newest_.number) return;
    newest_ = std::move(set);
    if (newer) {
        lastFrame_ = nowSeconds();
        for (const SharedFrame& frame : newest_.byRung)
            if (frame) measureFrameTime(frame->facts.publishedNs);
        for (auto& [id, session] : sessions_) {
            session.delivery.offered();
            session.delivery.rate().setFrameTime(frameTime_);
        }
    }
    for (auto& [id, session] : sessions_) pump(session, newer);
    updateDemand();
}

void Room::measureFrameTime(std::int64_t publishedNs) {
    constexpr double kShortest = 1.0 / 60, kLongest = 0.5, kNew = 0.1;
    const double seconds = 1e-9 * static_cast<double>(publishedNs - lastPublishedNs_);
    if (lastPublishedNs_ != 0 && seconds > 0 && seconds < kLongest)
        frameTime_ += kNew * (std::max(seconds, kShortest) - frameTime_);
    if (publishedNs > lastPublishedNs_) lastPublishedNs_ = publishedNs;
}

void Room::pump(Session& session, bool fresh) {
    const double now = nowSeconds();
    if (session.outlet->busy() || session.delivery.rate().sentBits(now) > allowance(now)) return;
    const std::optional<Shipment> shipment = session.delivery.next(newest_, now);
    if (!shipment) return;
    const std::int64_t published = shipment->frame->facts.publishedNs;
    const std::int64_t age = std::clamp<std::int64_t>((nowNanoseconds() - published) / 1000, 0, 0xffffffff);
    session.bytes += kHeaderBytes + shipment->size;
    bytesSent_ += kHeaderBytes + shipment->size;
    if (shipment->part) {
        ++partsSent_;
    } else {
        ++framesSent_[static_cast<std::size_t>(shipment->rung)];
        const bool saw = published > static_cast<std::int64_t>(1e9 * session.began);
        session.writing = fresh && saw ? published : 0;
    }
    session.outlet->sendBinary(
        headerOf(*shipment, inputBefore(session, published), static_cast<std::uint32_t>(age)), &*shipment);
}

void Room::updateDemand() {
    const double now = nowSeconds(), most = allowance(now);
    FrameDemand demand;
    demand.stream = newest_.stream;
    for (const auto& [id, session] : sessions_) {
        const Delivery& delivery = session.delivery;
        demand.anyone |= delivery.view().visible;
        demand.still |= delivery.wantsStill();
        demand.fine |= delivery.wantsFine();
        if (session.outlet->busy() || delivery.rate().sentBits(now) > most) continue;
        const std::optional<int> rung = delivery.wanted();
        if (!rung) continue;
        std::uint64_t& above = demand.above[static_cast<std::size_t>(*rung)];
        const bool same = delivery.sentStream() == newest_.stream;
        above = std::min(above, same ? delivery.sentNumber() : 0);
    }
    frames_->setDemand(demand);
}

double Room::sentBits(double now) const {
    double all = 0;
    for (const auto& [id, session] : sessions_) all += session.delivery.rate().sentBits(now);
    return all;
}

double Room::allowance(double now) const {
    const bool free = stream_.mostBits <= 0 || sentBits(now) <= stream_.mostBits;
    return free ? std::numeric_limits<double>::infinity()
                : stream_.mostBits / static_cast<double>(sessions_.size());
}

/// Those that take more than an equal share get coarser frames: more of them than if they only waited.
void Room::shareLimit() {
    if (stream_.mostBits <= 0 || sessions_.empty()) return;
    const double now = nowSeconds(), share = stream_.mostBits / static_cast<double>(sessions_.size());
    const double all = sentBits(now);
    for (auto& [id, session] : sessions_) {
        RateControl& rate = session.delivery.rate();
        constexpr double kRoom = 0.6;
        if (all > stream_.mostBits && rate.sentBits(now) > share)
            rate.limit(std::min(std::max(rate.rung(), rate.finest()) + 1, kRungCount - 1));
        else if (all < kRoom * stream_.mostBits)
            rate.limit(std::max(rate.finest() - 1, 0));
    }
}

} // namespace bridge
