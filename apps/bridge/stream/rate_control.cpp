#include "bridge/stream/rate_control.h"

#include <algorithm>
#include <cmath>

namespace bridge {

namespace {

constexpr Seconds kBaseMemory = 60; // frames alone never show the delay of a link that they fill
constexpr double kLate = 1.5, kVeryLate = 5, kGood = 0.3; ///< of a frame's time
constexpr int kLateAcks = 3;                              ///< so many running make frames coarser
constexpr Seconds kBetweenChanges = 0.3;
constexpr Seconds kFirstClimbWait = 2, kLongestClimbWait = 16;
constexpr Seconds kFailedClimb = 2; ///< a climb that is taken back so soon has failed
constexpr double kKept = 0.7;       ///< of the frames: less is too slow
constexpr int kLeastWindow = 2, kMostWindow = 6;
constexpr double kNarrow = 8e6 / 8, kVeryNarrow = 4e6 / 8; ///< bytes per second
constexpr std::size_t kPart = 32768, kLeastPart = 4096;
constexpr Seconds kPartTime = 0.06; ///< on the link
constexpr Seconds kFluent = 1.0 / 20;
constexpr Seconds kLeastTransit = 1e-3;

} // namespace

void RateControl::noteBase(Seconds rtt, Seconds now) {
    while (!bases_.empty() && bases_.back().rtt >= rtt) bases_.pop_back();
    bases_.push_back({now, rtt});
    while (bases_.size() > 1 && now - bases_.front().time > kBaseMemory) bases_.pop_front();
}

Seconds RateControl::base() const { return bases_.empty() ? 0 : bases_.front().rtt; }

void RateControl::sent(std::uint32_t stream, std::uint64_t number, bool part, std::size_t bytes,
                       Seconds now) {
    flight_.push_back({stream, number, part, bytes, now});
    recent_ = sentBits(now) / 8 + static_cast<double>(bytes);
    lastSent_ = now;
    if (!part) ++sent_;
}

bool RateControl::acked(std::uint32_t stream, std::uint64_t number, bool part, Seconds decode, Seconds now) {
    const auto found = std::find_if(flight_.begin(), flight_.end(), [&](const Entry& each) {
        return each.stream == stream && each.number == number && each.part == part;
    });
    if (found == flight_.end()) return false;
    const Entry entry = *found;
    flight_.erase(flight_.begin(), found + 1); // messages keep their order
    rtt_ = now - entry.time;
    noteBase(std::max(0.0, rtt_ - decode), now);
    queue_ = std::max(0.0, rtt_ - decode - base());
    noteBandwidth(entry.bytes, queue_, lastAck_ < 0 ? rtt_ : now - lastAck_);
    lastAck_ = now;
    if (!part) decide(entry, decode, now);
    return true;
}

// Neither waiting behind others nor an idle link makes it look slower than it is.
void RateControl::noteBandwidth(std::size_t bytes, Seconds transit, Seconds sinceAck) {
    const Seconds took = std::max(kLeastTransit, std::min(transit, sinceAck));
    const double rate = static_cast<double>(bytes) / took;
    constexpr double kNew = 0.3;
    bandwidth_ = bandwidth_ == 0 ? rate : bandwidth_ + kNew * (rate - bandwidth_);
}

void RateControl::decide(const Entry& entry, Seconds decode, Seconds now) {
    lateAcks_ = queue_ > kLate * frameTime_ ? lateAcks_ + 1 : 0;
    const bool late = lateAcks_ >= kLateAcks || queue_ > std::max(kVeryLate * frameTime_, 2 * kFluent);
    const bool behind = fallsBehind(now) && (queue_ > kGood * frameTime_ || decode > frameTime_);
    if (late || behind) {
        goodSince_ = -1;
        if (now - lastChange_ >= kBetweenChanges) lower(entry, now);
        return;
    }
    if (queue_ > kGood * frameTime_) {
        goodSince_ = -1;
        return;
    }
    if (goodSince_ < 0) goodSince_ = now;
    if (now - goodSince_ < climbWait_ || rung_ <= finest_) return;
    --rung_;
    lastChange_ = lastClimb_ = goodSince_ = now;
}

/// To what the link is known to carry, or one step.
void RateControl::lower(const Entry& entry, Seconds now) {
    const bool failed = now - lastClimb_ < kFailedClimb;
    climbWait_ = failed ? std::min(2 * climbWait_, kLongestClimbWait) : kFirstClimbWait;
    const double perUnit =
        static_cast<double>(entry.bytes) / kRungs[static_cast<std::size_t>(rung_)].relative;
    const double room = bandwidth_ * std::max(frameTime_, kFluent);
    int next = std::min(rung_ + 1, kRungCount - 1);
    while (next < kRungCount - 1 && perUnit * kRungs[static_cast<std::size_t>(next)].relative > room) ++next;
    rung_ = failed ? std::min(rung_ + 1, kRungCount - 1) : next;
    lastChange_ = now;
    lateAcks_ = 0;
}

bool RateControl::fallsBehind(Seconds now) {
    if (countedFrom_ < 0) countedFrom_ = now;
    constexpr Seconds kCounted = 1;
    constexpr int kEnough = 5;
    if (now - countedFrom_ < kCounted) return false;
    const bool behind = offered_ >= kEnough && sent_ < kKept * offered_;
    countedFrom_ = now;
    offered_ = sent_ = 0;
    return behind;
}

bool RateControl::windowOpen() const {
    const auto frames =
        std::count_if(flight_.begin(), flight_.end(), [](const Entry& each) { return !each.part; });
    return frames < window();
}

bool RateControl::partWindowOpen() const {
    constexpr std::size_t kMost = 4, kMostNarrow = 2;
    return flight_.size() < (bandwidth_ < kVeryNarrow ? kMostNarrow : kMost);
}

std::size_t RateControl::partBytes() const {
    if (bandwidth_ == 0) return kPart;
    return std::clamp(static_cast<std::size_t>(bandwidth_ * kPartTime), kLeastPart, kPart);
}

int RateControl::window() const {
    const double frames = std::ceil(base() / std::max(frameTime_, 1e-3)) + 1;
    return static_cast<int>(std::clamp(frames, double(kLeastWindow), double(kMostWindow)));
}

int RateControl::rung() const {
    if (pinned_) return std::max(*pinned_, finest_);
    return std::max(rung_, finest_);
}

double RateControl::sentBits(Seconds now) const { return 8 * recent_ * std::exp(lastSent_ - now); }

bool RateControl::narrow() const { return bandwidth_ > 0 && bandwidth_ < kNarrow; }

LinkReport RateControl::report() const { return {rtt_, base(), queue_, 8 * bandwidth_, window(), rung()}; }

} // namespace bridge
