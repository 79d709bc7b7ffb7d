#include "ipc/endpoint/link.h"

#include "ipc/channel/shared_copy.h"
#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/error.h"
#include "ipc/platform/rules.h"

#include <fmt/core.h>

#include <cstddef>
#include <thread>

namespace ipc {

namespace {

constexpr auto kSilence = std::chrono::milliseconds(30);    ///< then the lock is looked at
constexpr auto kBusyAfter = std::chrono::milliseconds(500); ///< slow frames are everyday life
constexpr auto kProbeEvery = std::chrono::milliseconds(20);

std::uint64_t pulseOf(const ServerPulse& pulse) {
    return pulse.alive.load(std::memory_order_relaxed) + pulse.progress.load(std::memory_order_relaxed);
}

[[noreturn]] void wrongVersion(const Names& names, const ControlFacts& facts) {
    const Handshake own = ownHandshake();
    const auto describe = [](const Handshake& side) {
        return fmt::format("protocol {}/{}, Boost {}, {} bit", side.protocolVersion, side.controlBytes,
                           side.boostVersion, 8 * side.pointerBytes);
    };
    throw Error(
        Problem::WrongVersion,
        "server '{0}' (process {1}) is of another version ({2}) than this program ({3}); use programs "
        "of one version",
        {names.instance(), std::to_string(facts.serverProcess), describe(facts.handshake), describe(own)});
}

} // namespace

Handshake ownHandshake() {
    return {.protocolVersion = kProtocolVersion,
            .controlBytes = sizeof(ControlBlock),
            .boostVersion = BOOST_VERSION,
            .pointerBytes = sizeof(void*),
            .byteOrder = 0x0102};
}

std::optional<ControlFacts> readControlFacts(const Segment& segment) {
    if (segment.bytes() < sizeof(ControlHeader)) return std::nullopt;
    const auto& header = *static_cast<const ControlHeader*>(segment.data());
    if (header.magic.load(std::memory_order_acquire) != kControlMagic) return std::nullopt;
    ControlFacts facts;
    copyFromShared(&facts.handshake, &header.handshake, sizeof(facts.handshake));
    copyFromShared(&facts.epoch, &header.epoch, sizeof(facts.epoch));
    copyFromShared(&facts.serverProcess, &header.serverProcess, sizeof(facts.serverProcess));
    if (facts.epoch == 0) return std::nullopt;
    return facts;
}

bool serverLives(const Segment& segment) {
    if (segment.locked(kServerLock)) return true;
    const std::optional<ControlFacts> facts = readControlFacts(segment);
    constexpr std::size_t known = offsetof(ControlBlock, pulse) + sizeof(ServerPulse);
    if (!facts || facts->handshake == ownHandshake() || segment.bytes() < known) return false;
    const ServerPulse& pulse = static_cast<const ControlBlock*>(segment.data())->pulse;
    const std::uint64_t before = pulseOf(pulse);
    for (int i = 0; i < 10 && pulseOf(pulse) == before; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return pulseOf(pulse) != before;
}

Link::Link(const Names& names, Segment segment, ControlFacts facts)
    : names_(names), segment_(std::move(segment)), facts_(std::move(facts)), pulse_(pulseOf(block().pulse)),
      lastPulse_(Clock::now()) {}

std::optional<Link> Link::open(const Names& names, Access access) {
    std::optional<Segment> segment = Segment::open(names.control(), access, sizeof(ControlHeader));
    if (!segment) return std::nullopt;
    std::optional<ControlFacts> facts = readControlFacts(*segment);
    if (!facts || !serverLives(*segment)) return std::nullopt;
    if (facts->handshake != ownHandshake() && keeps("versions are compared")) wrongVersion(names, *facts);
    if (segment->bytes() < sizeof(ControlBlock)) return std::nullopt;
    Link link(names, std::move(*segment), std::move(*facts));
    if (link.block().pulse.phase.load(std::memory_order_acquire) != ServerPhase::Running) return std::nullopt;
    return link;
}

// The same epoch with a still pulse is a dead server's whose successor already has the lock.
std::optional<Link> Link::successor(Access access) const {
    std::optional<Link> next;
    try {
        next = open(names_, access);
    } catch (const Error& error) {
        if (error.problem != Problem::System) throw;
    }
    if (next && next->epoch() == epoch() && next->pulse_ == pulse_) return std::nullopt;
    return next;
}

LinkState Link::check() {
    const ServerPhase phase = block().pulse.phase.load(std::memory_order_acquire);
    std::uint64_t epoch = 0;
    copyFromShared(&epoch, &block().header.epoch, sizeof epoch);
    // Another epoch in the same segment: it was overwritten, now or when it was first read.
    if (phase != ServerPhase::Running || epoch != facts_.epoch) state_ = LinkState::Gone;
    if (state_ == LinkState::Gone) return state_;
    const Clock::time_point now = Clock::now();
    const std::uint64_t pulse = pulseOf(block().pulse);
    if (pulse != pulse_) {
        pulse_ = pulse;
        lastPulse_ = now;
        return state_ = LinkState::Connected;
    }
    if (now - lastPulse_ >= kSilence && now - lastProbe_ >= kProbeEvery) {
        lastProbe_ = now;
        state_ = probe(now);
    }
    return state_;
}

LinkState Link::probe(Clock::time_point now) const {
    const bool unlocked = !segment_.locked(kServerLock) && keeps("a server without its lock is gone");
    if (unlocked || replaced()) return LinkState::Gone;
    if (now - lastPulse_ < kBusyAfter) return state_;
    return keeps("silence is no death") ? LinkState::Busy : LinkState::Gone;
}

// A stopped server whose names were removed still has its lock when another takes the name: the epoch tells.
bool Link::replaced() const {
    try {
        const std::optional<Segment> now = Segment::open(names_.control(), Access::Read, 0);
        const std::optional<ControlFacts> facts = now ? readControlFacts(*now) : std::nullopt;
        return facts && facts->epoch != facts_.epoch && keeps("a link looks at the epoch");
    } catch (const Error&) {
        return false; // short of descriptors, or not a server's: nothing that tells of a death
    }
}

} // namespace ipc
