/// How fast and how fine one viewer is served, from its acknowledgements alone: behind a tunnel or a proxy
/// the system's own figures describe the way to the tunnel.
#pragma once

#include "bridge/stream/rung.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace bridge {

/// Seconds of any clock that is never set.
using Seconds = double;

/// A figure of the link, for people.
struct LinkReport {
    Seconds rtt = 0, base = 0, queue = 0, decode = 0; ///< of the last acknowledged frame
    double bitsPerSecond = 0;                         ///< that the link carried at least; 0: not known
    int window = 2;
    int rung = kFirstRung;
};

/// Pure: it is told all times. A frame's time on its way is `rtt`; `base` is the least delay of the last
/// minute, which latency alone explains; what is left without the decoding is time in queues. These may be
/// the link's, or those of processors that are busy: a link that carries so many bytes needs the time for
/// each of them, while others now and then let one through at once, and so show what the link can do. Frames
/// get coarser where the link is not known to carry them, or where the page decodes too slowly. One thread.
class RateControl {
  public:
    explicit RateControl(int firstRung = kFirstRung) : rung_(firstRung) {}

    /// Between two frames of the server.
    void setFrameTime(Seconds seconds) { frameTime_ = seconds; }
    /// A small message went there and back.
    void ponged(Seconds rtt, Seconds now) { noteBase(rtt, 0, now); }
    /// The finest rung to be used, so that all viewers together keep within a limit; kRungs's first: none.
    void limit(int finest) { limit_ = finest; }
    /// The finest one that the page wants.
    void floor(int finest) { floor_ = finest; }
    int finest() const { return std::max(limit_, floor_); }
    /// Bits per second that are sent, over the last second or so.
    double sentBits(Seconds now) const;
    /// The rung to begin with.
    void beginAt(int rung) { rung_ = rung; }
    /// A fixed rung, or none.
    void pin(std::optional<int> rung) { pinned_ = rung; }

    /// A frame that might have been sent, whether it was or not.
    void offered() { ++offered_; }
    void sent(std::uint32_t stream, std::uint64_t number, bool part, std::size_t bytes, Seconds now);
    /// False: nothing such is under way.
    bool acked(std::uint32_t stream, std::uint64_t number, bool part, Seconds decode, Seconds now);

    /// Whether another frame may be sent.
    bool windowOpen() const;
    /// Whether another part of a still may be.
    bool partWindowOpen() const;
    /// Bytes of such a part: less on narrow links, where a movement must not wait for it.
    std::size_t partBytes() const;

    int rung() const;
    int window() const;
    std::size_t inFlight() const { return flight_.size(); }
    /// Below it a coarser image goes before the exact one.
    bool narrow() const;
    LinkReport report() const;

  private:
    struct Entry {
        std::uint32_t stream;
        std::uint64_t number;
        bool part;
        std::size_t bytes;
        Seconds time;
    };

    void noteBase(Seconds rtt, std::size_t bytes, Seconds now);
    Seconds base() const;
    void noteBandwidth(std::size_t bytes, Seconds transit, Seconds sinceAck);
    void noteProof(std::size_t bytes, Seconds way, Seconds now);
    double bandwidth() const;
    double provenBandwidth() const;
    /// Whether the link carries frames of a rung with ease, as far as `entry` and those before it show.
    bool carries(int rung, const Entry& entry) const;
    bool mayClimb(const Entry& entry) const;
    void decide(const Entry& entry, Seconds now);
    /// `failed`: a climb is taken back.
    void lower(const Entry& entry, bool failed, Seconds now);
    bool fallsBehind(Seconds now);

    Seconds frameTime_ = 1.0 / 30;
    int rung_;
    int limit_ = 0, floor_ = 0;
    std::optional<int> pinned_;
    std::deque<Entry> flight_;
    /// Least delays, the oldest first, each less than all later ones.
    struct Sample {
        Seconds time, rtt;
        std::size_t bytes; ///< of the message
    };
    std::deque<Sample> bases_;
    /// Rates that the link has carried, bytes per second, the fastest first, each above all later ones.
    struct Proof {
        Seconds time;
        int ack; ///< counted
        double bytesPerSecond;
    };
    std::deque<Proof> proofs_;
    int acks_ = 0;
    double carried_ = 0; ///< bytes, and the seconds that took: older ones fade
    Seconds carriedIn_ = 0;
    double recent_ = 0; ///< bytes of the last second, older ones fading
    Seconds lastSent_ = 0;
    Seconds lastAck_ = -1, rtt_ = 0, queue_ = 0, decode_ = 0, usualDecode_ = 0;
    Seconds onLink_ = 0; ///< time that the last frame took on the link, about
    int lateAcks_ = 0, drawn_ = 0;
    bool climbedByProof_ = false; ///< the last time
    Seconds lastChange_ = -1e9, lastClimb_ = -1e9, goodSince_ = -1, climbWait_ = 2;
    Seconds countedFrom_ = -1;
    int offered_ = 0, sent_ = 0;
};

} // namespace bridge
