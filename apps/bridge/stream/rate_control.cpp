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
constexpr Seconds kFailedClimb = 3; ///< a climb that is taken back so soon has failed
constexpr double kKept = 0.7;       ///< of the frames: less is too slow
constexpr int kMinWindow = 2, kMaxWindow = 6;
constexpr double kNarrow = 8e6 / 8, kVeryNarrow = 4e6 / 8; ///< bytes per second
constexpr std::size_t kPart = 32768, kMinPart = 4096;
constexpr Seconds kPartTime = 0.06; ///< on the link
constexpr Seconds kFluent = 1.0 / 20;
constexpr Seconds kMinTransit = 1e-3;
constexpr double kUsed = 0.8; ///< of a narrow link: what is left keeps queues short
// A frame that takes less than half of the time until the next one is carried with ease.
constexpr double kEase = 0.5;
constexpr Seconds kEasyFrame = 1.0 / 30;
constexpr Seconds kProofMemory = 2;
constexpr int kProofAcks = 3;         ///< a pause, after which a few come late, proves nothing
constexpr std::size_t kBaseBytes = 4; ///< a delay counts as that of an empty message for so many times more
constexpr Seconds kProvenClimbWait = 0.5;

} // namespace

void RateControl::noteBase(Seconds rtt, std::size_t bytes, Seconds now) {
    while (!bases_.empty() && bases_.back().rtt >= rtt) bases_.pop_back();
    bases_.push_back({now, rtt, bytes});
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
    ++acks_;
    rtt_ = now - entry.time;
    noteBase(std::max(0.0, rtt_ - decode), entry.bytes, now);
    queue_ = std::max(0.0, rtt_ - decode - base());
    noteBandwidth(entry.bytes, queue_, lastAck_ < 0 ? rtt_ : now - lastAck_);
    noteProof(entry.bytes, std::max(0.0, rtt_ - decode), now);
    lastAck_ = now;
    if (part) return true;
    constexpr double kNew = 0.15;
    ++drawn_;
    decode_ = decode;
    usualDecode_ = usualDecode_ == 0 ? decode : usualDecode_ + kNew * (decode - usualDecode_);
    onLink_ = static_cast<double>(entry.bytes) / bandwidth();
    decide(entry, now);
    return true;
}

// Neither waiting behind others nor an idle link makes it look slower than it is. Bytes and times are added
// up apart: acknowledgements that come together do not make it look faster.
void RateControl::noteBandwidth(std::size_t bytes, Seconds transit, Seconds sinceAck) {
    constexpr double kKeep = 0.7;
    carried_ = kKeep * carried_ + static_cast<double>(bytes);
    carriedIn_ = kKeep * carriedIn_ + std::max(kMinTransit, std::min(transit, sinceAck));
}

/// The link took no longer for it than its time on the way; less the least delay, where that is the one of a
/// much smaller message.
void RateControl::noteProof(std::size_t bytes, Seconds way, Seconds now) {
    while (!proofs_.empty() && now - proofs_.front().time > kProofMemory &&
           acks_ - proofs_.front().ack >= kProofAcks)
        proofs_.pop_front();
    const Seconds took = bases_.front().bytes * kBaseBytes <= bytes ? way - base() : way;
    const double rate = static_cast<double>(bytes) / std::max(kMinTransit, took);
    while (!proofs_.empty() && proofs_.back().bytesPerSecond <= rate) proofs_.pop_back();
    proofs_.push_back({now, acks_, rate});
}

double RateControl::provenBandwidth() const { return proofs_.empty() ? 0 : proofs_.front().bytesPerSecond; }

double RateControl::bandwidth() const {
    return std::max(carriedIn_ == 0 ? 0 : carried_ / carriedIn_, provenBandwidth());
}

bool RateControl::carries(int rung, const Entry& entry) const {
    const double bytes = static_cast<double>(entry.bytes) * kRungs[static_cast<std::size_t>(rung)].relative /
                         kRungs[static_cast<std::size_t>(rung_)].relative;
    return bytes < kEase * std::max(frameTime_, kEasyFrame) * provenBandwidth();
}

void RateControl::decide(const Entry& entry, Seconds now) {
    lateAcks_ = queue_ > kLate * frameTime_ ? lateAcks_ + 1 : 0;
    const bool late = lateAcks_ >= kLateAcks || queue_ > std::max(kVeryLate * frameTime_, 2 * kFluent);
    const bool behind = fallsBehind(now);
    const bool slowPage = behind && usualDecode_ > frameTime_;
    const bool slowLink = !carries(rung_, entry) && (late || (behind && queue_ > kGood * frameTime_));
    if (slowPage || slowLink) {
        goodSince_ = -1;
        const bool failed = now - lastClimb_ < kFailedClimb && (slowPage || !climbedByProof_);
        if (now - lastChange_ >= kBetweenChanges) lower(entry, failed, now);
        return;
    }
    if (!mayClimb(entry)) {
        goodSince_ = -1;
        return;
    }
    if (goodSince_ < 0) goodSince_ = now;
    const bool proven = carries(rung_ - 1, entry) && climbWait_ <= kFirstClimbWait;
    if (now - goodSince_ < (proven ? kProvenClimbWait : climbWait_)) return;
    --rung_;
    climbedByProof_ = proven;
    lastChange_ = lastClimb_ = goodSince_ = now;
}

/// To a finer rung, after a while.
bool RateControl::mayClimb(const Entry& entry) const {
    if (rung_ <= finest()) return false;
    if (usualDecode_ > frameTime_) return false;
    return queue_ <= kGood * frameTime_ || carries(rung_ - 1, entry);
}

/// To what the link is known to carry, or one step.
void RateControl::lower(const Entry& entry, bool failed, Seconds now) {
    climbWait_ = failed ? std::min(2 * climbWait_, kLongestClimbWait) : kFirstClimbWait;
    const double perUnit =
        static_cast<double>(entry.bytes) / kRungs[static_cast<std::size_t>(rung_)].relative;
    const double room = kUsed * bandwidth() * std::max(frameTime_, kFluent);
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
    // The capacity of a link is not known before it has carried something.
    return frames < std::min(window(), kMinWindow + drawn_);
}

bool RateControl::partWindowOpen() const {
    constexpr std::size_t kMax = 4, kMaxNarrow = 2;
    return flight_.size() < (bandwidth() < kVeryNarrow ? kMaxNarrow : kMax);
}

std::size_t RateControl::partBytes() const {
    if (bandwidth() == 0) return kPart;
    const double max = std::min(bandwidth() * kPartTime, static_cast<double>(kPart));
    return std::max(static_cast<std::size_t>(max), kMinPart);
}

int RateControl::window() const {
    // A link that takes longer for a frame than the server does holds fewer of them.
    const Seconds interval = std::max({frameTime_, onLink_, 1e-3});
    const double frames = std::ceil(base() / interval) + 1;
    return static_cast<int>(std::clamp(frames, double(kMinWindow), double(kMaxWindow)));
}

int RateControl::rung() const {
    if (pinned_) return std::max(*pinned_, finest());
    return std::max(rung_, finest());
}

double RateControl::sentBits(Seconds now) const { return 8 * recent_ * std::exp(lastSent_ - now); }

bool RateControl::narrow() const { return bandwidth() > 0 && bandwidth() < kNarrow; }

LinkReport RateControl::report() const {
    return {rtt_, base(), queue_, decode_, 8 * bandwidth(), window(), rung()};
}

} // namespace bridge
