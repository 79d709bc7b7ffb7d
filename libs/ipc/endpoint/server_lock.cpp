#include "ipc/endpoint/server_lock.h"

#include "ipc/endpoint/link.h"
#include "ipc/layout/control_block.h"
#include "ipc/platform/error.h"

#include <thread>

namespace ipc {

namespace {

[[noreturn]] void alreadyRunning(const Names& names, const std::optional<ControlFacts>& facts) {
    if (!facts) {
        throw Error(Problem::AlreadyRunning,
                    "server '{0}' is already running; stop it or name another instance", {names.instance()});
    }
    throw Error(Problem::AlreadyRunning,
                "server '{0}' is already running (process {1}); stop it or name another instance",
                {names.instance(), std::to_string(facts->serverProcess)});
}

std::optional<ControlFacts> factsByName(const Names& names) {
    const std::optional<Segment> segment = Segment::open(names.control(), Access::Read, 0);
    return segment ? readControlFacts(*segment) : std::nullopt;
}

// Only the holder of the lock removes the name, and only while it names the locked segment: so no two
// processes can.
void removeDead(const Names& names) {
    try {
        const std::optional<Segment> found = Segment::open(names.control(), Access::Write, 0);
        if (!found || serverLives(*found) || !found->tryLock(kServerLock)) return;
        if (found->named()) Segment::remove(names.control());
    } catch (const Error& error) {
        if (error.problem != Problem::NotYours) throw;
        Segment::remove(names.control()); // a link of ours, a file that is open to others
        (void)Segment::open(names.control(), Access::Read, 0); // throws again when it is still there
    }
}

} // namespace

std::optional<Segment> tryClaimControl(const Names& names, std::size_t bytes) {
    removeDead(names);
    return Segment::createLocked(names.control(), bytes, kServerLock);
}

Segment claimControl(const Names& names, std::size_t bytes, Clock::time_point deadline) {
    while (true) {
        if (std::optional<Segment> control = tryClaimControl(names, bytes)) return std::move(*control);
        if (Clock::now() >= deadline) alreadyRunning(names, factsByName(names));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

void refuseRival(const Names& names) {
    const std::optional<ControlFacts> facts = factsByName(names);
    if (facts) alreadyRunning(names, facts);
}

void removeSegments(const Names& names) {
    for (const std::string& name : segmentNames(names.prefix())) {
        if (name != names.control()) Segment::remove(name);
    }
}

} // namespace ipc
